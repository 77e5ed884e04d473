// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/generator/mesh_solid.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <unordered_map>
#include <vector>

#include "shapegauge/datasets/generator/shape_of_mesh.h"

// Internal to the sources that use CGAL.

namespace shapegauge {

namespace {

namespace processing = CGAL::Polygon_mesh_processing;

using SolidKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using HalfedgeMesh = CGAL::Surface_mesh<SolidKernel::Point_3>;

/// Values at the points of a grid; approximate far from the surface.
struct Grid {
  Eigen::Vector3d origin;
  double step = 0;
  Eigen::Vector3i points;
  std::vector<float> values;

  [[nodiscard]] std::size_t index(const Eigen::Vector3i& at) const {
    return (static_cast<std::size_t>(at.z()) * static_cast<std::size_t>(points.y()) +
            static_cast<std::size_t>(at.y())) *
               static_cast<std::size_t>(points.x()) +
           static_cast<std::size_t>(at.x());
  }
  [[nodiscard]] Eigen::Vector3d position(const Eigen::Vector3i& at) const { return origin + step * at.cast<double>(); }
};

constexpr int block = 8;  ///< points per side

template <typename Visit>
void for_each_point(const Eigen::Vector3i& first, const Eigen::Vector3i& end, Visit visit) {
  for (int z = first.z(); z < end.z(); ++z) {
    for (int y = first.y(); y < end.y(); ++y) {
      for (int x = first.x(); x < end.x(); ++x) visit(Eigen::Vector3i(x, y, z));
    }
  }
}

Grid sampled(const SolidObject& object, double step) {
  // Functions may overestimate distances by a factor of two.
  constexpr double caution = 2;
  Eigen::AlignedBox3d box;
  for (const SolidPart& part : object.parts) box.extend(part.solid.box);
  Grid grid;
  grid.step = step;
  grid.origin = box.min().array() - 2.5 * step;
  grid.points = ((box.sizes().array() / step).ceil() + 6).cast<int>();
  grid.values.resize(grid.index(grid.points - Eigen::Vector3i::Ones()) + 1);
  const Eigen::Vector3i blocks = (grid.points.array() + block - 1) / block;
  const double reach = caution * std::numbers::sqrt3 * step * block / 2;
  for_each_point(Eigen::Vector3i::Zero(), blocks, [&](const Eigen::Vector3i& at) {
    const Eigen::Vector3i first = block * at;
    const Eigen::Vector3i end = (first.array() + block).min(grid.points.array());
    const double middle = object.distance(grid.position(first) + Eigen::Vector3d::Constant(step * (block - 1) / 2.0));
    const bool far = std::abs(middle) > reach;
    for_each_point(first, end, [&](const Eigen::Vector3i& point) {
      grid.values[grid.index(point)] = static_cast<float>(far ? middle : object.distance(grid.position(point)));
    });
  });
  return grid;
}

/// Extracts the surface where a grid's values change sign, by tetrahedra about the diagonals of its cells.
class MarchingTetrahedra {
 public:
  explicit MarchingTetrahedra(const Grid& grid) : grid_(grid) {
    for_each_point(Eigen::Vector3i::Zero(), grid.points - Eigen::Vector3i::Ones(),
                   [&](const Eigen::Vector3i& cell) { add_cell(cell); });
  }

  HalfedgeMesh mesh;

 private:
  struct Corner {
    Eigen::Vector3i at;
    double value;
  };

  void add_cell(const Eigen::Vector3i& cell) {
    std::array<Corner, 8> corners;
    int inside = 0;
    for (int c = 0; c < 8; ++c) {
      const Eigen::Vector3i at = cell + Eigen::Vector3i(c & 1, (c >> 1) & 1, c >> 2);
      corners[static_cast<std::size_t>(c)] = {at, grid_.values[grid_.index(at)]};
      inside += corners[static_cast<std::size_t>(c)].value < 0 ? 1 : 0;
    }
    if (inside == 0 || inside == 8) return;
    // Around the diagonal from corner 0 to 7; positively oriented.
    constexpr std::array<std::array<std::size_t, 2>, 6> rings = {{{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}}};
    for (const auto& [a, b] : rings) add_tetrahedron({corners[0], corners[a], corners[b], corners[7]});
  }

  void add_tetrahedron(std::array<Corner, 4> corners) {
    // Inside corners first; a swap of two reverses the tetrahedron, and another swap restores its orientation.
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return corners[i].value < 0 ? 0 : 1; });
    const auto inside = std::ranges::count_if(corners, [](const Corner& corner) { return corner.value < 0; });
    if (inside == 0 || inside == 4) return;
    int swaps = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) swaps += order[i] > order[j] ? 1 : 0;
    }
    const bool odd = swaps % 2 != 0;
    const auto on = [&](std::size_t i, std::size_t j) { return vertex_between(corners[order[i]], corners[order[j]]); };
    if (inside == 1) add_triangle(on(0, 1), on(0, 2), on(0, 3), odd);
    if (inside == 3) add_triangle(on(3, 0), on(3, 1), on(3, 2), odd);
    if (inside == 2) {
      add_triangle(on(0, 2), on(0, 3), on(1, 2), odd);
      add_triangle(on(1, 2), on(0, 3), on(1, 3), odd);
    }
  }

  HalfedgeMesh::Vertex_index vertex_between(const Corner& a, const Corner& b) {
    // Ensures that triangles have an area.
    constexpr double min_share = 0.03;
    const std::size_t low = std::min(grid_.index(a.at), grid_.index(b.at));
    const std::size_t high = std::max(grid_.index(a.at), grid_.index(b.at));
    const auto [position, is_new] = vertices_.try_emplace(8 * low + edge_kind(high - low));
    if (is_new) {
      const double share = std::clamp(a.value / (a.value - b.value), min_share, 1 - min_share);
      const Eigen::Vector3d point = (1 - share) * grid_.position(a.at) + share * grid_.position(b.at);
      position->second = mesh.add_vertex({point.x(), point.y(), point.z()});
    }
    return position->second;
  }

  /// Returns which of the seven directions an edge has.
  [[nodiscard]] std::size_t edge_kind(std::size_t difference) const {
    std::size_t kind = 1;
    while (grid_.index({static_cast<int>(kind & 1U), static_cast<int>((kind >> 1U) & 1U),
                        static_cast<int>(kind >> 2U)}) != difference) {
      ++kind;
    }
    return kind;
  }

  void add_triangle(HalfedgeMesh::Vertex_index a, HalfedgeMesh::Vertex_index b, HalfedgeMesh::Vertex_index c,
                    bool turned) {
    mesh.add_face(a, turned ? c : b, turned ? b : c);
  }

  const Grid& grid_;
  std::unordered_map<std::size_t, HalfedgeMesh::Vertex_index> vertices_;
};

bool is_sound(HalfedgeMesh& mesh) {
  const auto component = mesh.add_property_map<HalfedgeMesh::Face_index, std::size_t>("component").first;
  return CGAL::is_closed(mesh) && processing::connected_components(mesh, component) == 1 &&
         processing::is_outward_oriented(mesh) && !processing::does_self_intersect(mesh);
}

SolidMesh with_labels(Shape mesh, const SolidObject& object) {
  Eigen::VectorXi labels(mesh.triangles.rows());
  for (Eigen::Index f = 0; f < labels.size(); ++f) {
    const Eigen::RowVector3d middle = mesh.vertices(mesh.triangles.row(f), Eigen::all).colwise().mean();
    labels[f] = object.label_at(middle.transpose());
  }
  return {std::move(mesh), std::move(labels)};
}

}  // namespace

std::optional<SolidMesh> mesh_solid(const SolidObject& object, int faces) {
  constexpr int attempts = 4;
  constexpr int rounds = 3;
  constexpr double tolerance = 0.18;     ///< of the number of triangles
  constexpr double usual_excess = 1.17;  ///< of triangles over those that the lengths of edges stand for
  constexpr double points_in_wall = 2;
  constexpr double longest_in_wall = 1.1;  ///< edge, in thicknesses of the thinnest wall
  constexpr double finer = 3;              ///< triangles of the grid for each requested one
  Grid coarse = sampled(object, 0.06);
  const auto near = std::ranges::count_if(coarse.values, [&](float v) { return std::abs(v) < coarse.step / 2; });
  const double area = static_cast<double>(near) * coarse.step * coarse.step;
  // A grid produces about six triangles for each square of its step.
  const double step = std::min(object.thinnest / points_in_wall, std::sqrt(6 * area / (finer * faces)));
  HalfedgeMesh fine = MarchingTetrahedra(sampled(object, step)).mesh;
  if (!is_sound(fine)) return std::nullopt;
  const double target_length =
      std::sqrt(usual_excess * CGAL::to_double(processing::area(fine)) * 4 / (std::numbers::sqrt3 * faces));
  double length = std::min(target_length, longest_in_wall * object.thinnest);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    HalfedgeMesh mesh = fine;
    processing::isotropic_remeshing(mesh.faces(), length, mesh, processing::parameters::number_of_iterations(rounds));
    mesh.collect_garbage();
    const double excess = static_cast<double>(mesh.number_of_faces()) / faces;
    const bool right = excess > 1 - tolerance && (excess < 1 + tolerance || length < (1 - tolerance) * target_length);
    if (right && is_sound(mesh)) return with_labels(shape_of_mesh(mesh), object);
    length *= right ? 0.97 : std::sqrt(excess);
  }
  return std::nullopt;
}

}  // namespace shapegauge

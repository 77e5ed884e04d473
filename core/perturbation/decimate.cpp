#include "shapegauge/core/perturbation/decimate.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <array>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/error.h"
#include "shapegauge/core/perturbation/decimation_mesh.h"
#include "shapegauge/core/perturbation/decimation_module.h"
#include "shapegauge/core/perturbation/required_extent.h"
#include "shapegauge/core/shape/merged_vertices.h"

namespace shapegauge {

namespace {

/// Collapses edges until at most so many faces are left; the number of collapses.
std::size_t collapse_edges(DecimationMesh& mesh, Eigen::Index faces) {
  OpenMesh::Decimater::DecimaterT<DecimationMesh> decimater(mesh);
  DecimationModule::Handle module;
  decimater.add(module);
  decimater.initialize();
  return decimater.decimate_to_faces(0, static_cast<std::size_t>(std::max(faces, Eigen::Index{0})));
}

/// The triangles that are left, in the shape's vertices.
Triangles triangles_left(const Shape& shape, DecimationInput& input) {
  const std::vector<std::int32_t> merged = merged_by_place(shape.vertices);
  std::vector<std::array<std::int32_t, 3>> left;
  for (const auto face : input.mesh.faces()) {  // without those that are deleted
    std::array<std::int32_t, 3> triangle{};
    std::size_t k = 0;
    for (const auto vertex : input.mesh.fv_range(face)) {
      triangle[k++] = input.vertices[static_cast<std::size_t>(vertex.idx())];
    }
    if (input.turned[static_cast<std::size_t>(face.idx())]) std::swap(triangle[1], triangle[2]);
    left.push_back(triangle);
  }
  for (const std::int32_t f : input.left_aside) {
    std::array<std::int32_t, 3> triangle{};
    for (int k = 0; k < 3; ++k) {
      triangle[static_cast<std::size_t>(k)] = merged[static_cast<std::size_t>(shape.triangles(f, k))];
    }
    left.push_back(triangle);
  }
  Triangles triangles(static_cast<Eigen::Index>(left.size()), 3);
  for (std::size_t i = 0; i < left.size(); ++i) {
    triangles.row(static_cast<Eigen::Index>(i)) << left[i][0], left[i][1], left[i][2];
  }
  return triangles;
}

/// The triangles with those vertices of the shape that they use, in their order.
Shape with_used_vertices(const Shape& shape, Triangles triangles) {
  std::vector<std::int32_t> renumbered(static_cast<std::size_t>(shape.vertices.rows()), -1);
  for (const std::int32_t vertex : triangles.reshaped()) renumbered[static_cast<std::size_t>(vertex)] = 0;
  Shape used;
  used.vertices.resize(shape.vertices.rows(), 3);
  std::int32_t count = 0;
  for (std::size_t i = 0; i < renumbered.size(); ++i) {
    if (renumbered[i] < 0) continue;
    used.vertices.row(count) = shape.vertices.row(static_cast<Eigen::Index>(i));
    renumbered[i] = count++;
  }
  used.vertices.conservativeResize(count, Eigen::NoChange);
  for (std::int32_t& vertex : triangles.reshaped()) vertex = renumbered[static_cast<std::size_t>(vertex)];
  used.triangles = std::move(triangles);
  return used;
}

}  // namespace

Shape decimate(const Shape& shape, Eigen::Index faces) {
  if (faces < 1) throw InputError(fmt::format("a mesh cannot be decimated to {} faces", faces));
  if (is_cloud(shape)) throw InputError("a point cloud cannot be decimated; sample fewer points of it");
  if (shape.triangles.rows() <= faces) return shape;
  required_diagonal(shape);
  DecimationInput input = decimation_input(shape);
  const auto left_aside = static_cast<Eigen::Index>(input.left_aside.size());
  const bool already = static_cast<Eigen::Index>(input.mesh.n_faces()) + left_aside <= faces;
  if (!already && collapse_edges(input.mesh, faces - left_aside) == 0) {
    throw InputError(fmt::format(
        "the mesh of {} faces cannot be decimated to {}: not one edge can be collapsed; too many edges have "
        "more than two faces, or it is as simple as it gets",
        shape.triangles.rows(), faces));
  }
  return with_used_vertices(shape, triangles_left(shape, input));
}

}  // namespace shapegauge

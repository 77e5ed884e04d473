// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/perturbation/decimate.h"

#include <Eigen/Geometry>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <algorithm>
#include <array>
#include <cstdint>
#include <fmt/format.h>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/shape/connectivity.h"

// Needed by QuadricT.hh, which does not include it.
// clang-format off
#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <OpenMesh/Core/Geometry/QuadricT.hh>
// clang-format on

namespace shapegauge {

namespace {

/// Double precision, and the marks of deleted and locked parts that decimation needs.
struct DecimationTraits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};

/// Half-edge mesh with a fast test for valid collapses, the most frequent operation of decimation. OpenMesh's own
/// library is slower because Debian builds it with assertions.
struct DecimationMesh : OpenMesh::TriMesh_ArrayKernelT<DecimationTraits> {
  /// Returns true if the mesh remains a manifold when the half-edge's first vertex is moved onto its second.
  [[nodiscard]] bool is_collapse_ok(HalfedgeHandle side) const;

 private:
  /// Returns the vertex opposite a side, invalid on the boundary.
  [[nodiscard]] VertexHandle apex(HalfedgeHandle side) const {
    return is_boundary(side) ? VertexHandle() : to_vertex_handle(next_halfedge_handle(side));
  }
  /// Returns true if the side's face has no neighbour across its other two sides.
  [[nodiscard]] bool hangs_on(HalfedgeHandle side) const {
    if (is_boundary(side)) return false;
    const HalfedgeHandle next = next_halfedge_handle(side);
    return is_boundary(opposite_halfedge_handle(next)) &&
           is_boundary(opposite_halfedge_handle(next_halfedge_handle(next)));
  }
  /// Returns the next half-edge from the same vertex.
  [[nodiscard]] HalfedgeHandle turned(HalfedgeHandle side) const {
    return next_halfedge_handle(opposite_halfedge_handle(side));
  }
};

bool DecimationMesh::is_collapse_ok(HalfedgeHandle side) const {
  const HalfedgeHandle other = opposite_halfedge_handle(side);
  const VertexHandle first = to_vertex_handle(other);
  const VertexHandle second = to_vertex_handle(side);
  if (status(edge_handle(side)).deleted() || status(first).deleted() || status(second).deleted()) return false;
  if (hangs_on(side) || hangs_on(other)) return false;
  const VertexHandle left = apex(side);
  const VertexHandle right = apex(other);
  if (left == right) return false;
  // An edge between two vertices of the boundary must be part of it.
  if (is_boundary(first) && is_boundary(second) && !is_boundary(side) && !is_boundary(other)) return false;
  // No other vertex may be adjacent to both.
  for (HalfedgeHandle a = turned(side); a != side; a = turned(a)) {
    const VertexHandle vertex = to_vertex_handle(a);
    if (vertex == left || vertex == right) continue;
    for (HalfedgeHandle b = turned(other); b != other; b = turned(b)) {
      if (to_vertex_handle(b) == vertex) return false;
    }
  }
  return true;
}

/// Triangle soup converted to a half-edge mesh for decimation.
struct DecimationInput {
  DecimationMesh mesh;                   ///< in the shape's unit frame
  std::vector<std::int32_t> vertices;    ///< per vertex of the mesh: the first coincident vertex of the shape
  std::vector<bool> turned;              ///< per face of the mesh: reversed with respect to the shape
  std::vector<std::int32_t> left_aside;  ///< triangles of the shape that the mesh cannot represent
};

/// Union-find with parity: each item may differ from its set's representative.
class ParitySets {
 public:
  explicit ParitySets(std::size_t size) : parent_(size), odd_(size) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// Returns the representative, and whether the item differs from it.
  std::pair<std::size_t, bool> find(std::size_t item) {
    std::size_t root = item;
    bool odd = false;
    while (parent_[root] != root) {
      odd = odd != odd_[root];
      root = parent_[root];
    }
    for (bool rest = odd; parent_[item] != item;) {
      const std::size_t next = std::exchange(parent_[item], root);
      const bool step = odd_[item];
      odd_[item] = rest;
      rest = rest != step;
      item = next;
    }
    return {root, odd};
  }

  /// Unites the sets of two items that must, or must not, differ; returns false on a contradiction.
  bool unite(std::size_t a, std::size_t b, bool differ) {
    const auto [root_a, odd_a] = find(a);
    const auto [root_b, odd_b] = find(b);
    if (root_a == root_b) return (odd_a != odd_b) == differ;
    parent_[root_b] = root_a;
    odd_[root_b] = (odd_a != odd_b) != differ;
    return true;
  }

 private:
  std::vector<std::size_t> parent_;
  std::vector<bool> odd_;
};

std::size_t corner_of(const HalfEdge& use, bool at_low) {
  const int corner = at_low == use.forward ? use.corner : (use.corner + 1) % 3;
  return 3 * static_cast<std::size_t>(use.triangle) + static_cast<std::size_t>(corner);
}

/// Surface cut open such that every vertex has one fan of faces.
struct CutSurface {
  ParitySets orientation;                 ///< parity of triangles: odd ones are reversed
  ParitySets corners;                     ///< corners of all triangles, united by fan
  std::vector<bool> locked;               ///< per vertex of the shape, welded
  std::vector<bool> has_three_positions;  ///< per triangle
};

CutSurface cut_surface(const Shape& shape, const std::vector<std::int32_t>& merged) {
  const auto triangles = static_cast<std::size_t>(shape.triangles.rows());
  CutSurface cut{.orientation = ParitySets(triangles),
                 .corners = ParitySets(3 * triangles),
                 .locked = std::vector<bool>(merged.size()),
                 .has_three_positions = std::vector<bool>(triangles)};
  const std::vector<HalfEdge> uses = half_edges(shape.triangles, merged);
  for_each_edge(uses, [&](std::span<const HalfEdge> edge) {
    for (const HalfEdge& use : edge) cut.has_three_positions[static_cast<std::size_t>(use.triangle)] = true;
    if (edge.size() == 1) return;
    const HalfEdge& first = edge[0];
    const HalfEdge& second = edge[1];
    const bool joins = edge.size() == 2 && cut.orientation.unite(static_cast<std::size_t>(first.triangle),
                                                                 static_cast<std::size_t>(second.triangle),
                                                                 first.forward == second.forward);
    if (joins) {
      for (const bool low : {true, false}) cut.corners.unite(corner_of(first, low), corner_of(second, low), false);
    } else {
      cut.locked[static_cast<std::size_t>(first.low)] = true;
      cut.locked[static_cast<std::size_t>(first.high)] = true;
    }
  });
  return cut;
}

using MeshTriangle = std::array<DecimationMesh::VertexHandle, 3>;

/// Returns true if the half-edge mesh can represent the face: none of its half-edges is in use.
bool can_hold(const DecimationMesh& mesh, const MeshTriangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!mesh.is_boundary(triangle[k])) return false;
    const auto side = mesh.find_halfedge(triangle[k], triangle[(k + 1) % 3]);
    if (side.is_valid() && !mesh.is_boundary(side)) return false;
  }
  return true;
}

/// Adds the triangles of a cut surface to the mesh, with one vertex for each fan.
void add_triangles(const Shape& shape, const std::vector<std::int32_t>& merged, CutSurface& cut,
                   DecimationInput& input) {
  const UnitFrame frame = unit_frame(shape);
  std::vector<DecimationMesh::VertexHandle> by_fan(3 * static_cast<std::size_t>(shape.triangles.rows()));
  for (std::size_t f = 0; f < cut.has_three_positions.size(); ++f) {
    if (!cut.has_three_positions[f]) continue;
    MeshTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t vertex =
          merged[static_cast<std::size_t>(shape.triangles(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(k)))];
      auto& handle = by_fan[cut.corners.find(3 * f + k).first];
      if (!handle.is_valid()) {
        const Eigen::Vector3d position = frame.to_unit(shape.vertices.row(vertex).transpose());
        handle = input.mesh.add_vertex({position[0], position[1], position[2]});
        input.vertices.push_back(vertex);
      }
      triangle[k] = handle;
    }
    const bool turned = cut.orientation.find(f).second;
    if (turned) std::swap(triangle[1], triangle[2]);
    if (can_hold(input.mesh, triangle) && input.mesh.add_face(triangle[0], triangle[1], triangle[2]).is_valid()) {
      input.turned.push_back(turned);
    } else {
      input.left_aside.push_back(static_cast<std::int32_t>(f));
    }
  }
}

/// Converts a shape to a half-edge mesh. Welds coincident vertices, drops faces with fewer than three distinct corners,
/// and orients adjacent faces consistently. Cuts the surface open along edges without exactly two consistent faces.
/// Vertices on these edges, and those of dropped triangles, are locked.
DecimationInput decimation_input(const Shape& shape) {
  const std::vector<std::int32_t> merged = welded_vertices(shape.vertices);
  CutSurface cut = cut_surface(shape, merged);
  DecimationInput input;
  add_triangles(shape, merged, cut, input);
  for (const std::int32_t f : input.left_aside) {
    for (int k = 0; k < 3; ++k) {
      cut.locked[static_cast<std::size_t>(merged[static_cast<std::size_t>(shape.triangles(f, k))])] = true;
    }
  }
  for (const auto vertex : input.mesh.vertices()) {
    const std::int32_t original = input.vertices[static_cast<std::size_t>(vertex.idx())];
    input.mesh.status(vertex).set_locked(cut.locked[static_cast<std::size_t>(original)]);
  }
  return input;
}

using Vector = DecimationMesh::Point;
using OpenMesh::Geometry::Quadricd;

/// Weight of the planes on boundary edges relative to those of the faces.
constexpr double open_edge_weight = 10;

Quadricd plane_quadric(const Vector& unit_normal, const Vector& point, double weight) {
  return Quadricd(unit_normal[0], unit_normal[1], unit_normal[2], -unit_normal.dot(point)) * weight;
}

/// Normal of a triangle with twice its area as length, and that area divided by the square of the longest side: 0 for a
/// degenerate triangle, 0.87 for an equilateral one.
struct Facing {
  Vector normal;
  double length;
  double roundness;

  Facing(const Vector& a, const Vector& b, const Vector& c) : normal((b - a).cross(c - a)), length(normal.norm()) {
    const double longest = std::max({(b - a).sqrnorm(), (c - b).sqrnorm(), (a - c).sqrnorm()});
    roundness = longest > 0 ? length / longest : 0;
  }
};

/// Priority of collapses: the quadric error (Garland and Heckbert 1997) of the faces' planes, weighted by area, and of
/// planes on boundary edges, which OpenMesh's own module lets erode. A collapse is illegal if a face would flip or
/// become a sliver.
class DecimationModule : public OpenMesh::Decimater::ModBaseT<DecimationMesh> {
 public:
  using Handle = OpenMesh::Decimater::ModHandleT<DecimationModule>;

  explicit DecimationModule(DecimationMesh& mesh) : ModBaseT(mesh, false) {}

  [[nodiscard]] const std::string& name() const override;
  void initialize() override;
  float collapse_priority(const CollapseInfo& collapse) override;
  void postprocess_collapse(const CollapseInfo& collapse) override;

 private:
  [[nodiscard]] bool keeps_faces(const CollapseInfo& collapse);

  std::vector<OpenMesh::Geometry::Quadricd> quadrics_;  ///< per vertex
  SparseInterruptionCheck check_;
};

const std::string& DecimationModule::name() const {
  static const std::string text = "quadric error without flipped faces";
  return text;
}

void DecimationModule::initialize() {
  quadrics_.assign(mesh().n_vertices(), Quadricd());
  for (const auto face : mesh().faces()) {
    auto side = mesh().halfedge_handle(face);
    const Vector a = mesh().point(mesh().from_vertex_handle(side));
    const Vector b = mesh().point(mesh().to_vertex_handle(side));
    const Vector c = mesh().point(mesh().to_vertex_handle(mesh().next_halfedge_handle(side)));
    const Vector cross = (b - a).cross(c - a);
    const double twice_area = cross.norm();
    if (!(twice_area > 0)) continue;
    const Vector normal = cross / twice_area;
    for (int k = 0; k < 3; ++k, side = mesh().next_halfedge_handle(side)) {
      const auto from = mesh().from_vertex_handle(side);
      const auto to = mesh().to_vertex_handle(side);
      quadrics_[static_cast<std::size_t>(from.idx())] += plane_quadric(normal, a, twice_area / 2);
      if (!mesh().is_boundary(mesh().opposite_halfedge_handle(side))) continue;
      const Vector edge = mesh().point(to) - mesh().point(from);
      const Quadricd wall =
          plane_quadric(normal.cross(edge).normalized(), mesh().point(from), open_edge_weight * edge.sqrnorm());
      for (const auto end : {from, to}) quadrics_[static_cast<std::size_t>(end.idx())] += wall;
    }
  }
}

bool DecimationModule::keeps_faces(const CollapseInfo& collapse) {
  constexpr double min_cosine = 0.17;  // 80 degrees
  constexpr double min_roundness = 0.02;
  for (const auto side : mesh().voh_range(collapse.v0)) {
    if (mesh().is_boundary(side)) continue;
    const auto second = mesh().to_vertex_handle(side);
    const auto third = mesh().to_vertex_handle(mesh().next_halfedge_handle(side));
    if (second == collapse.v1 || third == collapse.v1) continue;  // a face that goes
    const Vector b = mesh().point(second);
    const Vector c = mesh().point(third);
    const Facing before(collapse.p0, b, c);
    const Facing after(collapse.p1, b, c);
    if (after.roundness < std::min(min_roundness, before.roundness)) return false;
    if (before.roundness > 0 && before.normal.dot(after.normal) < min_cosine * before.length * after.length)
      return false;
  }
  return true;
}

float DecimationModule::collapse_priority(const CollapseInfo& collapse) {
  check_();
  if (!keeps_faces(collapse)) return ILLEGAL_COLLAPSE;
  const Quadricd sum =
      quadrics_[static_cast<std::size_t>(collapse.v0.idx())] + quadrics_[static_cast<std::size_t>(collapse.v1.idx())];
  return static_cast<float>(std::max(0.0, sum(collapse.p1)));
}

void DecimationModule::postprocess_collapse(const CollapseInfo& collapse) {
  quadrics_[static_cast<std::size_t>(collapse.v1.idx())] += quadrics_[static_cast<std::size_t>(collapse.v0.idx())];
}

/// Collapses edges until at most `faces` faces are left; returns the number of collapses.
std::size_t collapse_edges(DecimationMesh& mesh, Eigen::Index faces) {
  OpenMesh::Decimater::DecimaterT<DecimationMesh> decimater(mesh);
  DecimationModule::Handle module;
  decimater.add(module);
  decimater.initialize();
  return decimater.decimate_to_faces(0, static_cast<std::size_t>(std::max(faces, Eigen::Index{0})));
}

/// Returns the remaining triangles with the shape's vertices.
Triangles triangles_left(const Shape& shape, DecimationInput& input) {
  const std::vector<std::int32_t> merged = welded_vertices(shape.vertices);
  std::vector<std::array<std::int32_t, 3>> left;
  for (const auto face : input.mesh.faces()) {  // skips deleted faces
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

/// Returns the triangles with the vertices that they use, in order.
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
  require_in_bounds("the number of faces to decimate to", static_cast<double>(faces), decimate_faces_bounds);
  if (is_cloud(shape)) throw InputError("a point cloud cannot be decimated; sample fewer points of it");
  if (shape.triangles.rows() <= faces) return shape;
  required_diagonal(shape);
  DecimationInput input = decimation_input(shape);
  const auto left_aside = static_cast<Eigen::Index>(input.left_aside.size());
  const bool already = static_cast<Eigen::Index>(input.mesh.n_faces()) + left_aside <= faces;
  if (!already && collapse_edges(input.mesh, faces - left_aside) == 0) {
    throw InputError(
        fmt::format("the mesh of {} faces cannot be decimated to {}: no edge can be collapsed, because too many edges "
                    "have more than two faces or no valid collapse is left",
                    shape.triangles.rows(), faces));
  }
  return with_used_vertices(shape, triangles_left(shape, input));
}

}  // namespace shapegauge

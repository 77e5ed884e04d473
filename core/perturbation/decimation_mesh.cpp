#include "shapegauge/core/perturbation/decimation_mesh.h"

#include <array>
#include <numeric>
#include <utility>

#include "shapegauge/core/shape/edge_uses.h"
#include "shapegauge/core/shape/merged_vertices.h"
#include "shapegauge/core/shape/unit_frame.h"

namespace shapegauge {

namespace {

/// Sets that are united one pair at a time; each item differs from its set's representative by a parity.
class ParitySets {
 public:
  explicit ParitySets(std::size_t size) : parent_(size), odd_(size) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The representative, and whether the item differs from it.
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

  /// Unites the sets of two items that are to differ or not; false where they are known to be the other way.
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

std::size_t corner_of(const EdgeUse& use, bool at_low) {
  const int corner = at_low == use.forward ? use.corner : (use.corner + 1) % 3;
  return 3 * static_cast<std::size_t>(use.triangle) + static_cast<std::size_t>(corner);
}

/// The surface cut open so that around each vertex there is one fan of faces.
struct CutSurface {
  ParitySets orientation;              ///< of the triangles: odd ones are to be turned
  ParitySets corners;                  ///< of all triangles: those of one fan
  std::vector<bool> locked;            ///< by vertex of the shape, merged by place
  std::vector<bool> has_three_places;  ///< by triangle
};

CutSurface cut_surface(const Shape& shape, const std::vector<std::int32_t>& merged) {
  const auto triangles = static_cast<std::size_t>(shape.triangles.rows());
  CutSurface cut{.orientation = ParitySets(triangles),
                 .corners = ParitySets(3 * triangles),
                 .locked = std::vector<bool>(merged.size()),
                 .has_three_places = std::vector<bool>(triangles)};
  const std::vector<EdgeUse> uses = edge_uses(shape.triangles, merged);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    for (const EdgeUse& use : edge) cut.has_three_places[static_cast<std::size_t>(use.triangle)] = true;
    if (edge.size() == 1) return;
    const EdgeUse& first = edge[0];
    const EdgeUse& second = edge[1];
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

/// Whether a half-edge mesh can take the face: none of its half-edges has one already.
bool can_hold(const DecimationMesh& mesh, const MeshTriangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!mesh.is_boundary(triangle[k])) return false;
    const auto side = mesh.find_halfedge(triangle[k], triangle[(k + 1) % 3]);
    if (side.is_valid() && !mesh.is_boundary(side)) return false;
  }
  return true;
}

/// Adds the triangles of a cut surface to the mesh, with a vertex for each fan.
void add_triangles(const Shape& shape, const std::vector<std::int32_t>& merged, CutSurface& cut,
                   DecimationInput& input) {
  const UnitFrame frame = unit_frame(shape);
  std::vector<DecimationMesh::VertexHandle> by_fan(3 * static_cast<std::size_t>(shape.triangles.rows()));
  for (std::size_t f = 0; f < cut.has_three_places.size(); ++f) {
    if (!cut.has_three_places[f]) continue;
    MeshTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t vertex =
          merged[static_cast<std::size_t>(shape.triangles(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(k)))];
      auto& handle = by_fan[cut.corners.find(3 * f + k).first];
      if (!handle.is_valid()) {
        const Eigen::Vector3d place = frame.to_unit(shape.vertices.row(vertex).transpose());
        handle = input.mesh.add_vertex({place[0], place[1], place[2]});
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

}  // namespace

DecimationInput decimation_input(const Shape& shape) {
  const std::vector<std::int32_t> merged = merged_by_place(shape.vertices);
  CutSurface cut = cut_surface(shape, merged);
  DecimationInput input;
  add_triangles(shape, merged, cut, input);
  for (const std::int32_t f : input.left_aside) {
    for (int k = 0; k < 3; ++k) {
      cut.locked[static_cast<std::size_t>(merged[static_cast<std::size_t>(shape.triangles(f, k))])] = true;
    }
  }
  for (const auto vertex : input.mesh.vertices()) {
    const std::int32_t place = input.vertices[static_cast<std::size_t>(vertex.idx())];
    input.mesh.status(vertex).set_locked(cut.locked[static_cast<std::size_t>(place)]);
  }
  return input;
}

}  // namespace shapegauge

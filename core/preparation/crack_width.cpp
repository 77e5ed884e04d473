#include "shapegauge/core/preparation/crack_width.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <vector>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/shape/connectivity.h"

namespace shapegauge {

namespace {

/// Returns half the distance from a point of the boundary across the crack in a direction. A ball that touches the
/// point shrinks until nothing is in it.
double half_width_at(const TriangleBVH& tree, const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                     double radius) {
  constexpr double touching = 1e-9;
  constexpr double inside = 1 - 1e-6;
  constexpr int max_contacts = 64;
  double half_width = 0;
  for (int contact = 0; contact < max_contacts && radius > touching; ++contact) {
    const std::optional<ClosestHit> hit = tree.closest(point + radius * direction, radius);
    if (!hit || !(hit->distance < inside * radius)) return half_width;
    const Eigen::Vector3d across = hit->point - point;
    half_width = across.norm() / 2;
    radius = across.squaredNorm() / (2 * across.dot(direction));
  }
  return 0;
}

}  // namespace

double half_crack_width(const Shape& mesh, const TriangleBVH& tree, double widest) {
  std::vector<HalfEdge> boundary;
  const std::vector<HalfEdge> uses = surface_half_edges(mesh, welding_of(mesh));
  for_each_edge(uses, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1) boundary.push_back(edge.front());
  });
  std::vector<double> widths(boundary.size());
  parallel_for(std::size_t{0}, boundary.size(), [&](std::size_t i) {
    const auto corner = [&](int k) -> Eigen::Vector3d {
      return mesh.vertices.row(mesh.triangles(boundary[i].triangle, (boundary[i].corner + k) % 3)).transpose();
    };
    const Eigen::Vector3d begin = corner(0);
    const Eigen::Vector3d along = (corner(1) - begin).normalized();
    const Eigen::Vector3d back = corner(2) - begin;
    const Eigen::Vector3d outwards = -(back - along.dot(back) * along).normalized();
    for (const Eigen::Vector3d& point : {begin, Eigen::Vector3d((begin + corner(1)) / 2), corner(1)}) {
      widths[i] = std::max(widths[i], half_width_at(tree, point, outwards, widest / 2));
    }
  });
  return widths.empty() ? 0 : std::ranges::max(widths);
}

}  // namespace shapegauge

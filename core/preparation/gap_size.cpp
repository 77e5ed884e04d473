#include "shapegauge/core/preparation/gap_size.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <vector>

#include "shapegauge/core/preparation/boundary_loops.h"
#include "shapegauge/core/preparation/inscribed_circle.h"
#include "shapegauge/core/shape/point_neighbours.h"

namespace shapegauge {

namespace {

double gap_in_cloud(const Points& points) {
  constexpr Eigen::Index neighbours = 6;
  constexpr double share = 0.999;
  if (points.rows() < 2) return 0;
  const PointNeighbours nearest = nearest_neighbours(points, neighbours);
  Eigen::VectorXd distances = nearest.distances.rightCols(1);
  const auto rank = static_cast<Eigen::Index>(share * static_cast<double>(distances.size() - 1));
  std::nth_element(distances.begin(), distances.begin() + rank, distances.end());
  return distances[rank];
}

/// The loop seen along its vector area.
std::vector<Eigen::Vector2d> flattened(const BoundaryLoop& loop, const Points& points) {
  const Eigen::Vector3d normal = loop.vector_area.normalized();
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross(u);
  const Eigen::Vector3d origin = points.row(loop.vertices.front());
  std::vector<Eigen::Vector2d> polygon;
  for (const std::int32_t vertex : loop.vertices) {
    const Eigen::Vector3d x = points.row(vertex).transpose() - origin;
    polygon.emplace_back(u.dot(x), v.dot(x));
  }
  return polygon;
}

double gap_in_mesh(const Shape& mesh, double limit) {
  std::vector<BoundaryLoop> loops = boundary_loops(mesh);
  std::ranges::sort(loops, std::greater<>(), &BoundaryLoop::radius_bound);
  double gap = 0;
  for (const BoundaryLoop& loop : loops) {
    if (loop.radius_bound <= gap) break;
    const double radius = inscribed_circle_radius(flattened(loop, mesh.vertices));
    if (radius <= limit) gap = std::max(gap, radius);
  }
  return gap;
}

}  // namespace

double gap_size(const Shape& shape, double limit) {
  return is_cloud(shape) ? gap_in_cloud(shape.vertices) : gap_in_mesh(shape, limit);
}

}  // namespace shapegauge

#include "shapegauge/core/preparation/gap_size.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "shapegauge/core/preparation/boundary_loops.h"
#include "shapegauge/core/shape/point_neighbours.h"
#include "shapegauge/core/shape/validity.h"

namespace shapegauge {

namespace {

/// The distance within which this share of the points have their sixth neighbour.
double distance_to_sixth(const Points& points, double share) {
  constexpr Eigen::Index neighbours = 6;
  if (points.rows() < 2) return 0;
  const PointNeighbours nearest = nearest_neighbours(points, neighbours);
  Eigen::VectorXd distances = nearest.distances.rightCols(1);
  const auto rank = static_cast<Eigen::Index>(share * static_cast<double>(distances.size() - 1));
  std::nth_element(distances.begin(), distances.begin() + rank, distances.end());
  return distances[rank];
}

double gap_in_mesh(const Shape& mesh) {
  constexpr double share = 0.99;
  std::vector<std::pair<double, double>> loops;  // radius and length
  double total = 0;
  for (const BoundaryLoop& loop : boundary_loops(mesh)) {
    loops.emplace_back(loop.radius, loop.length);
    total += loop.length;
  }
  std::ranges::sort(loops);
  double gap = 0;
  double below = 0;
  for (const auto& [radius, length] : loops) {
    if (below >= share * total) break;
    gap = radius;
    below += length;
  }
  return gap;
}

}  // namespace

double gap_size(const Shape& shape) {
  require_usable(shape);
  return is_cloud(shape) ? distance_to_sixth(shape.vertices, 0.999) : gap_in_mesh(shape);
}

double point_spacing(const Shape& shape) {
  require_usable(shape);
  return is_cloud(shape) ? distance_to_sixth(shape.vertices, 0.5) : 0;
}

}  // namespace shapegauge

#include "shapegauge/core/preparation/gap_size.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

/// Boundary edges by vertex, for walking along each once.
class BoundaryEdges {
 public:
  explicit BoundaryEdges(std::span<const HalfEdge> uses) {
    for_each_edge(uses, [&](std::span<const HalfEdge> edge) {
      if (edge.size() != 1) return;
      const auto index = static_cast<std::int32_t>(walked_.size());
      walked_.push_back(false);
      ends_.push_back({edge[0].low, index, edge[0].high});
      ends_.push_back({edge[0].high, index, edge[0].low});
    });
    std::ranges::sort(ends_, {}, [](const End& end) { return std::pair(end.vertex, end.edge); });
  }

  /// Returns a vertex with an unused edge, in ascending order over calls; -1 if there is none.
  std::int32_t start() {
    while (next_ < ends_.size() && walked_[static_cast<std::size_t>(ends_[next_].edge)]) ++next_;
    return next_ < ends_.size() ? ends_[next_].vertex : -1;
  }

  /// Walks along an unused edge from the vertex and returns its other end, or -1 if there is none.
  std::int32_t walk_from(std::int32_t vertex) {
    for (auto end = std::ranges::lower_bound(ends_, vertex, {}, &End::vertex);
         end != ends_.end() && end->vertex == vertex; ++end) {
      if (walked_[static_cast<std::size_t>(end->edge)]) continue;
      walked_[static_cast<std::size_t>(end->edge)] = true;
      return end->other;
    }
    return -1;
  }

 private:
  struct End {
    std::int32_t vertex;
    std::int32_t edge;
    std::int32_t other;
  };
  std::vector<End> ends_;
  std::vector<bool> walked_;
  std::size_t next_ = 0;
};

BoundaryLoop measured(std::vector<std::int32_t> vertices, const Points& points) {
  BoundaryLoop loop{.vertices = std::move(vertices)};
  const Eigen::RowVector3d origin = points.row(loop.vertices.front());
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    const Eigen::RowVector3d a = points.row(loop.vertices[i]);
    const Eigen::RowVector3d b = points.row(loop.vertices[(i + 1) % loop.vertices.size()]);
    loop.length += (b - a).norm();
    loop.vector_area += (a - origin).cross(b - origin).transpose() / 2;
  }
  return loop;
}

/// Returns the distance from x to the polygon's sides, negative outside (even-odd rule).
double signed_distance(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& x) {
  double squared = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const Eigen::Vector2d ab = b - a;
    const double length = ab.squaredNorm();
    const double t = length > 0 ? std::clamp(ab.dot(x - a) / length, 0.0, 1.0) : 0;
    squared = std::min(squared, (a + t * ab - x).squaredNorm());
    const bool crosses = (a.y() > x.y()) != (b.y() > x.y());
    if (crosses && x.x() < a.x() + (x.y() - a.y()) / ab.y() * ab.x()) inside = !inside;
  }
  return inside ? std::sqrt(squared) : -std::sqrt(squared);
}

/// Square that may contain the centre.
struct Square {
  Eigen::Vector2d centre;
  double half;   ///< of its edge
  double bound;  ///< upper bound of the radius for centres in the square
};

/// Returns the distance within which this fraction of the points have their sixth neighbour.
double distance_to_sixth(const Points& points, double fraction) {
  constexpr Eigen::Index neighbours = 6;
  if (points.rows() < 2) return 0;
  const PointNeighbours nearest = nearest_neighbours(points, neighbours);
  Eigen::VectorXd distances = nearest.distances.rightCols(1);
  const auto rank = static_cast<Eigen::Index>(fraction * static_cast<double>(distances.size() - 1));
  std::nth_element(distances.begin(), distances.begin() + rank, distances.end());
  return distances[rank];
}

/// Projects the loop along its vector area.
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

GapSizes gaps_in_mesh(const Shape& mesh, double limit) {
  std::vector<BoundaryLoop> loops = boundary_loops(mesh);
  std::ranges::sort(loops, std::greater<>(), &BoundaryLoop::radius_bound);
  GapSizes gaps;
  for (const BoundaryLoop& loop : loops) {
    if (loop.radius_bound() <= gaps.within_limit) break;
    const double radius = inscribed_circle_radius(flattened(loop, mesh.vertices));
    gaps.widest = std::max(gaps.widest, radius);
    if (radius <= limit) gaps.within_limit = std::max(gaps.within_limit, radius);
  }
  return gaps;
}

}  // namespace

std::vector<BoundaryLoop> boundary_loops(const Shape& shape) {
  require_usable(shape);
  BoundaryEdges edges(half_edges(shape.triangles, welded_vertices(shape.vertices)));
  std::vector<BoundaryLoop> loops;
  std::vector<std::int64_t> place_in_path(static_cast<std::size_t>(shape.vertices.rows()), -1);
  for (std::int32_t start = edges.start(); start >= 0; start = edges.start()) {
    std::vector<std::int32_t> path;
    const auto take_from = [&](std::int64_t first) {
      const std::vector<std::int32_t> loop(path.begin() + first, path.end());
      for (const std::int32_t v : loop) place_in_path[static_cast<std::size_t>(v)] = -1;
      path.resize(static_cast<std::size_t>(first));
      loops.push_back(measured(loop, shape.vertices));
    };
    for (std::int32_t vertex = start; vertex >= 0; vertex = edges.walk_from(vertex)) {
      if (const std::int64_t before = place_in_path[static_cast<std::size_t>(vertex)]; before >= 0) take_from(before);
      place_in_path[static_cast<std::size_t>(vertex)] = static_cast<std::int64_t>(path.size());
      path.push_back(vertex);
    }
    if (path.size() > 1) take_from(0);
    if (!path.empty()) place_in_path[static_cast<std::size_t>(path.front())] = -1;
  }
  return loops;
}

double inscribed_circle_radius(const std::vector<Eigen::Vector2d>& polygon) {
  if (polygon.size() < 3) return 0;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : polygon) box.extend(corner);
  const double negligible = 1e-3 * box.diagonal().norm();
  double best = 0;
  const auto smaller_bound = [](const Square& a, const Square& b) { return a.bound < b.bound; };
  std::priority_queue<Square, std::vector<Square>, decltype(smaller_bound)> waiting(smaller_bound);
  const auto look_at = [&](const Eigen::Vector2d& centre, double half) {
    const double distance = signed_distance(polygon, centre);
    best = std::max(best, distance);
    // Distances change by at most the distance from the centre.
    waiting.push({centre, half, distance + std::sqrt(2.0) * half});
  };
  look_at(box.center(), box.sizes().maxCoeff() / 2);
  while (waiting.top().bound > 1.01 * best + negligible) {
    const Square square = waiting.top();
    waiting.pop();
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) look_at(square.centre + square.half * Eigen::Vector2d(x, y), square.half / 2);
    }
  }
  return best;
}

GapSizes gap_sizes(const Shape& shape, double limit) {
  require_usable(shape);
  if (!is_cloud(shape)) return gaps_in_mesh(shape, limit);
  const double gap = distance_to_sixth(shape.vertices, 0.999);
  return {gap, gap};
}

double gap_size(const Shape& shape, double limit) { return gap_sizes(shape, limit).within_limit; }

double point_spacing(const Shape& shape) {
  require_usable(shape);
  return is_cloud(shape) ? distance_to_sixth(shape.vertices, 0.5) : 0;
}

}  // namespace shapegauge

#include "shapegauge/core/preparation/boundary_loops.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "shapegauge/core/shape/edge_uses.h"
#include "shapegauge/core/shape/merged_vertices.h"

namespace shapegauge {

namespace {

/// Boundary edges by their vertices, to be walked along once each.
class BoundaryEdges {
 public:
  explicit BoundaryEdges(std::span<const EdgeUse> uses) {
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
      if (edge.size() != 1) return;
      const auto index = static_cast<std::int32_t>(walked_.size());
      walked_.push_back(false);
      ends_.push_back({edge[0].low, index, edge[0].high});
      ends_.push_back({edge[0].high, index, edge[0].low});
    });
    std::ranges::sort(ends_, {}, [](const End& end) { return std::pair(end.vertex, end.edge); });
  }

  /// Some vertex with an edge that has not been walked, at or after those asked for before; -1 where there is none.
  std::int32_t start() {
    while (next_ < ends_.size() && walked_[static_cast<std::size_t>(ends_[next_].edge)]) ++next_;
    return next_ < ends_.size() ? ends_[next_].vertex : -1;
  }

  /// Walks an edge from the vertex; its other end, or -1 where all have been walked.
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
  if (loop.length > 0) loop.radius_bound = 2 * loop.vector_area.norm() / loop.length;
  return loop;
}

}  // namespace

std::vector<BoundaryLoop> boundary_loops(const Shape& shape) {
  BoundaryEdges edges(edge_uses(shape.triangles, merged_by_place(shape.vertices)));
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

}  // namespace shapegauge

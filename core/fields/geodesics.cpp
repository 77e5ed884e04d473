// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/fields/geodesics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/fields/geodesics_cgal.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/distinct_triangles.h"
#include "shapegauge/core/shape/link_components.h"

namespace shapegauge {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Distinct positions of a shape's used vertices: the nodes of a graph.
struct Nodes {
  Points points;
  std::vector<std::int32_t> vertices;  ///< the first vertex at each node
  std::vector<std::int32_t> of;        ///< node of each vertex; -1 for unused
};

Nodes nodes_of(const Shape& shape, std::span<const std::int32_t> merged) {
  std::vector<char> used(merged.size(), is_cloud(shape) ? 1 : 0);
  for (const std::int32_t v : shape.triangles.reshaped<Eigen::RowMajor>()) {
    used[static_cast<std::size_t>(merged[static_cast<std::size_t>(v)])] = 1;
  }
  Nodes nodes;
  nodes.of.assign(merged.size(), -1);
  for (std::size_t v = 0; v < merged.size(); ++v) {
    const auto first = static_cast<std::size_t>(merged[v]);
    if (first == v && used[v] != 0) {
      nodes.of[v] = static_cast<std::int32_t>(nodes.vertices.size());
      nodes.vertices.push_back(static_cast<std::int32_t>(v));
    }
    nodes.of[v] = nodes.of[first];
  }
  nodes.points = shape.vertices(nodes.vertices, Eigen::all);
  return nodes;
}

/// Returns the length of the straight segment between the corners opposite an edge, in the unfolded plane of its two
/// triangles; infinity if the segment does not cross the edge.
double across(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& p,
              const Eigen::RowVector3d& q) {
  const double length = (b - a).norm();
  if (!(length > 0)) return infinity;
  const Eigen::RowVector3d axis = (b - a) / length;
  const double along_p = (p - a).dot(axis);
  const double along_q = (q - a).dot(axis);
  const double height_p = (p - a - along_p * axis).norm();
  const double height_q = (q - a - along_q * axis).norm();
  if (!(height_p + height_q > 0)) return infinity;
  const double crossing = along_p + (along_q - along_p) * height_p / (height_p + height_q);
  if (!(crossing >= 0 && crossing <= length)) return infinity;
  return std::hypot(along_p - along_q, height_p + height_q);
}

/// Returns the edges of a mesh and the segments across them.
std::vector<Segment> mesh_segments(const Shape& shape, std::span<const std::int32_t> merged, const Nodes& nodes) {
  std::vector<Segment> segments;
  const std::vector<HalfEdge> uses = half_edges(shape.triangles, merged);
  const auto node = [&](std::int32_t vertex) { return nodes.of[static_cast<std::size_t>(vertex)]; };
  const auto opposite = [&](const HalfEdge& use) { return shape.triangles(use.triangle, (use.corner + 2) % 3); };
  for_each_edge(uses, [&](std::span<const HalfEdge> edge) {
    const auto a = shape.vertices.row(edge.front().low);
    const auto b = shape.vertices.row(edge.front().high);
    segments.push_back({node(edge.front().low), node(edge.front().high), (b - a).norm()});
    if (edge.size() != 2) return;
    const std::int32_t p = opposite(edge.front());
    const std::int32_t q = opposite(edge.back());
    const double length = across(a, b, shape.vertices.row(p), shape.vertices.row(q));
    if (length < infinity && node(p) != node(q)) segments.push_back({node(p), node(q), length});
  });
  return segments;
}

/// Adjacency of nodes in one array.
class Graph {
 public:
  Graph(Nodes nodes, const std::vector<Segment>& segments) : nodes_(std::move(nodes)) {
    std::vector<Segment> arcs;  // from a to b
    for (const Segment& s : segments) arcs.insert(arcs.end(), {s, {s.b, s.a, s.length}});
    arcs_ = bucket_sort(arcs, nodes_.vertices.size(), [](const Segment& arc) { return arc.a; });
  }

  /// Dijkstra's algorithm.
  [[nodiscard]] Eigen::VectorXd distances_from(std::int32_t vertex) const {
    using Entry = std::pair<double, std::int32_t>;
    std::vector<double> distance(nodes_.vertices.size(), infinity);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const std::int32_t source = nodes_.of[static_cast<std::size_t>(vertex)];
    if (source >= 0) {
      distance[static_cast<std::size_t>(source)] = 0;
      open.emplace(0, source);
    }
    const SparseInterruptionCheck check;
    while (!open.empty()) {
      check();
      const auto [reached, from] = open.top();
      open.pop();
      const auto node = static_cast<std::size_t>(from);
      if (reached > distance[node]) continue;
      for (std::size_t i = arcs_.first[node]; i < arcs_.first[node + 1]; ++i) {
        const Segment& arc = arcs_.values[i];
        double& known = distance[static_cast<std::size_t>(arc.b)];
        if (!(reached + arc.length < known)) continue;
        known = reached + arc.length;
        open.emplace(known, arc.b);
      }
    }
    return at_vertices(distance);
  }

 private:
  [[nodiscard]] Eigen::VectorXd at_vertices(const std::vector<double>& distance) const {
    Eigen::VectorXd result(static_cast<Eigen::Index>(nodes_.of.size()));
    for (std::size_t v = 0; v < nodes_.of.size(); ++v) {
      const std::int32_t node = nodes_.of[v];
      const double value = node < 0 ? nan : distance[static_cast<std::size_t>(node)];
      result[static_cast<Eigen::Index>(v)] = std::isfinite(value) ? value : nan;
    }
    return result;
  }

  Nodes nodes_;
  BucketSorted<Segment> arcs_;
};

GeodesicDistances graph_distances(const Shape& shape, std::span<const std::int32_t> merged, int neighbours) {
  Nodes nodes = nodes_of(shape, merged);
  std::vector<Segment> segments =
      is_cloud(shape) ? nearest_segments(nodes.points, neighbours) : mesh_segments(shape, merged, nodes);
  link_components(nodes.points, neighbours, segments);
  const auto graph = std::make_shared<const Graph>(std::move(nodes), segments);
  return [graph](std::int32_t source) { return graph->distances_from(source); };
}

}  // namespace

GeodesicDistances geodesic_distances(const Shape& shape, const GeodesicOptions& options) {
  check_options("geodesic distances", geodesic_table, options);
  require_usable(shape);
  if (shape.vertices.rows() == 0)
    throw InputError("geodesic distances need a shape with vertices, and this one has none");
  const std::vector<std::int32_t> merged = welded_vertices(shape.vertices);
  if (options.method == GeodesicMethod::graph) return graph_distances(shape, merged, options.neighbours);
  Shape merged_shape = without_duplicates(shape);
  for (std::int32_t& v : merged_shape.triangles.reshaped()) v = merged[static_cast<std::size_t>(v)];
  const GeodesicDistances distances = geodesic_distances_cgal(merged_shape, options.method);
  return [merged, distances](std::int32_t source) {
    const Eigen::VectorXd to_merged = distances(merged[static_cast<std::size_t>(source)]);
    return Eigen::VectorXd(to_merged(merged));
  };
}

}  // namespace shapegauge

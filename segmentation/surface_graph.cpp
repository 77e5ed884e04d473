// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/surface_graph.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

constexpr Eigen::Index neighbours_in_cloud = 8;

/// Maximum number of boundary edges at a vertex; with more, triangles meet there by chance.
constexpr std::size_t max_border_ends = 12;

struct Pair {
  std::int32_t from;
  SurfaceLink link;
  bool over_gap = false;
};

/// Returns an angle that is positive if each of two points lies in front of the other's plane, assuming consistent
/// orientation.
double signed_angle(const Eigen::Vector3d& way, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  if (from.isZero(0) || to.isZero(0)) return 0;
  const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
  return (from - to).dot(way) > 0 ? angle : -angle;
}

void add_both_ways(std::vector<Pair>& pairs, Pair pair) {
  pairs.push_back(pair);
  std::swap(pair.from, pair.link.to);
  pairs.push_back(pair);
}

void add_edge(std::vector<Pair>& pairs, const Shape& mesh, const Samples& samples, const HalfEdge& a,
              const HalfEdge& b) {
  const Eigen::Vector3d low = mesh.vertices.row(a.low);
  const Eigen::Vector3d high = mesh.vertices.row(a.high);
  const Eigen::Vector3d from = samples.points.row(a.triangle);
  const Eigen::Vector3d to = samples.points.row(b.triangle);
  const Eigen::Vector3d middle = (low + high) / 2;
  const Eigen::Vector3d normal = samples.normals.row(a.triangle);
  const double side = a.forward == b.forward ? -1 : 1;
  add_both_ways(
      pairs,
      {.from = a.triangle,
       .link = {.to = b.triangle,
                .length = (high - low).norm(),
                .distance = (middle - from).norm() + (to - middle).norm(),
                .concavity = signed_angle(to - from, normal, side * samples.normals.row(b.triangle).transpose())}});
}

/// End of a boundary edge.
struct BorderEnd {
  std::int32_t vertex;
  std::int32_t triangle;
  double length;  ///< of the edge
};

/// Links two triangles across the gap at a common vertex, with the properties of the missing edge.
void add_bridge(std::vector<Pair>& pairs, const Shape& mesh, const Samples& samples, const BorderEnd& a,
                const BorderEnd& b) {
  const Eigen::Vector3d vertex = mesh.vertices.row(a.vertex);
  const Eigen::Vector3d from = samples.points.row(a.triangle);
  const Eigen::Vector3d to = samples.points.row(b.triangle);
  const Eigen::Vector3d normal = samples.normals.row(a.triangle);
  const Eigen::Vector3d other = samples.normals.row(b.triangle);
  add_both_ways(
      pairs,
      {.from = a.triangle,
       .link = {.to = b.triangle,
                .length = std::min(a.length, b.length) / 2,
                .distance = (vertex - from).norm() + (to - vertex).norm(),
                .concavity = signed_angle(to - from, normal, normal.dot(other) < 0 ? Eigen::Vector3d(-other) : other)},
       .over_gap = true});
}

void add_bridges(std::vector<Pair>& pairs, const Shape& mesh, const Samples& samples, std::vector<BorderEnd> ends) {
  std::ranges::sort(ends, {}, [](const BorderEnd& end) { return std::tie(end.vertex, end.triangle, end.length); });
  for (std::size_t begin = 0; begin < ends.size();) {
    std::size_t end = begin + 1;
    while (end < ends.size() && ends[end].vertex == ends[begin].vertex) ++end;
    for (std::size_t i = begin; i < end && end - begin <= max_border_ends; ++i) {
      for (std::size_t k = i + 1; k < end; ++k) {
        if (ends[i].triangle != ends[k].triangle) add_bridge(pairs, mesh, samples, ends[i], ends[k]);
      }
    }
    begin = end;
  }
}

std::vector<Pair> pairs_of_mesh(const Shape& mesh, const Samples& samples) {
  std::vector<Pair> pairs;
  const std::vector<std::int32_t> merged = welded_vertices(mesh.vertices);
  std::vector<BorderEnd> ends;
  for_each_edge(half_edges(mesh.triangles, merged), [&](std::span<const HalfEdge> uses) {
    for (std::size_t i = 1; i < uses.size(); ++i) add_edge(pairs, mesh, samples, uses[i - 1], uses[i]);
    if (uses.size() > 1) return;
    const double length = (mesh.vertices.row(uses[0].high) - mesh.vertices.row(uses[0].low)).norm();
    ends.push_back({uses[0].low, uses[0].triangle, length});
    ends.push_back({uses[0].high, uses[0].triangle, length});
  });
  add_bridges(pairs, mesh, samples, std::move(ends));
  return pairs;
}

std::vector<Pair> pairs_of_cloud(const Samples& samples) {
  std::vector<Pair> pairs;
  const PointNeighbours nearest = nearest_neighbours(samples.points, neighbours_in_cloud);
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    for (Eigen::Index k = 0; k < nearest.indices.cols(); ++k) {
      const std::int32_t j = nearest.indices(i, k);
      const Eigen::Vector3d way = (samples.points.row(j) - samples.points.row(i)).transpose();
      const Eigen::Vector3d from = samples.normals.row(i);
      const Eigen::Vector3d to = samples.normals.row(j);
      add_both_ways(pairs,
                    {.from = static_cast<std::int32_t>(i),
                     .link = {.to = j,
                              .length = (std::sqrt(samples.weights[i]) + std::sqrt(samples.weights[j])) / 2,
                              .distance = nearest.distances(i, k),
                              .concavity = signed_angle(way, from, from.dot(to) < 0 ? Eigen::Vector3d(-to) : to)}});
    }
  }
  return pairs;
}

}  // namespace

SurfaceGraph surface_graph(const Shape& shape) {
  require_usable(shape);
  if (shape.vertices.rows() == 0) throw InputError("an empty shape has nothing to segment");
  SurfaceGraph graph;
  graph.samples = sample_shape(shape, SampleSite::faces);
  std::vector<Pair> pairs = is_cloud(shape) ? pairs_of_cloud(graph.samples) : pairs_of_mesh(shape, graph.samples);
  // Two triangles that touch at a vertex of a gap may have several links: the longest is kept. Triangles that share an
  // edge need none.
  const SparseInterruptionCheck check;
  std::sort(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) {
    check();
    return std::tie(a.from, a.link.to, a.over_gap, b.link.length) <
           std::tie(b.from, b.link.to, b.over_gap, a.link.length);
  });
  const auto same = [](const Pair& a, const Pair& b) { return a.from == b.from && a.link.to == b.link.to; };
  pairs.erase(std::unique(pairs.begin(), pairs.end(), same), pairs.end());

  graph.first.assign(static_cast<std::size_t>(graph.size()) + 1, 0);
  graph.links.reserve(pairs.size());
  for (const Pair& pair : pairs) {
    ++graph.first[static_cast<std::size_t>(pair.from) + 1];
    graph.links.push_back(pair.link);
  }
  for (std::size_t i = 1; i < graph.first.size(); ++i) graph.first[i] += graph.first[i - 1];
  return graph;
}

}  // namespace shapegauge

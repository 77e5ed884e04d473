#include "shapegauge/segmentation/surface_graph.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

constexpr Eigen::Index neighbours_in_cloud = 8;

struct Pair {
  std::int32_t from;
  SurfaceLink link;
};

/// Positive where each of two points lies in front of the other's plane, or would if they were oriented alike.
double signed_angle(const Eigen::Vector3d& way, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  if (from.isZero(0) || to.isZero(0)) return 0;
  const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
  return (from - to).dot(way) > 0 ? angle : -angle;
}

void add_both_ways(std::vector<Pair>& pairs, std::int32_t from, SurfaceLink link) {
  pairs.push_back({from, link});
  std::swap(from, link.to);
  pairs.push_back({from, link});
}

void add_edge(std::vector<Pair>& pairs, const Shape& mesh, const Samples& samples, const EdgeUse& a, const EdgeUse& b) {
  const Eigen::Vector3d low = mesh.vertices.row(a.low);
  const Eigen::Vector3d high = mesh.vertices.row(a.high);
  const Eigen::Vector3d from = samples.points.row(a.triangle);
  const Eigen::Vector3d to = samples.points.row(b.triangle);
  const Eigen::Vector3d middle = (low + high) / 2;
  const Eigen::Vector3d normal = samples.normals.row(a.triangle);
  const double side = a.forward == b.forward ? -1 : 1;
  add_both_ways(pairs, a.triangle,
                {.to = b.triangle,
                 .length = (high - low).norm(),
                 .distance = (middle - from).norm() + (to - middle).norm(),
                 .concavity = signed_angle(to - from, normal, side * samples.normals.row(b.triangle).transpose())});
}

std::vector<Pair> pairs_of_mesh(const Shape& mesh, const Samples& samples) {
  std::vector<Pair> pairs;
  const std::vector<std::int32_t> merged = merged_by_place(mesh.vertices);
  for_each_edge(edge_uses(mesh.triangles, merged), [&](std::span<const EdgeUse> uses) {
    for (std::size_t i = 1; i < uses.size(); ++i) add_edge(pairs, mesh, samples, uses[i - 1], uses[i]);
  });
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
      add_both_ways(pairs, static_cast<std::int32_t>(i),
                    {.to = j,
                     .length = (std::sqrt(samples.weights[i]) + std::sqrt(samples.weights[j])) / 2,
                     .distance = nearest.distances(i, k),
                     .concavity = signed_angle(way, from, from.dot(to) < 0 ? Eigen::Vector3d(-to) : to)});
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
  // Two triangles may share two edges: the longer one is kept.
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.from, a.link.to, b.link.length) < std::tie(b.from, b.link.to, a.link.length);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/segmentation_proxy.h"

#include <cstddef>
#include <numeric>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/perturbation/sample_points.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "shapegauge/core/shape/samples.h"

namespace shapegauge {

namespace {

constexpr Eigen::Index min_triangles = 8000;
constexpr Eigen::Index points_of_cracked = 10000;
constexpr double max_open_edges = 0.05;

/// Subdivides each triangle into four at the midpoints of its edges, in order, the middle one first.
Shape cut_into_four(const Shape& mesh) {
  const std::vector<std::int32_t> merged = welded_vertices(mesh.vertices);
  const std::vector<HalfEdge> uses = half_edges(mesh.triangles, merged);
  const Eigen::Index corners = mesh.vertices.rows();
  // Triangles with coincident corners, which half_edges() omits, get separate sides.
  Eigen::Matrix<std::int32_t, Eigen::Dynamic, 3, Eigen::RowMajor> middle =
      Eigen::Matrix<std::int32_t, Eigen::Dynamic, 3, Eigen::RowMajor>::Constant(mesh.triangles.rows(), 3, -1);
  auto next = static_cast<std::int32_t>(corners);
  for_each_edge(uses, [&](std::span<const HalfEdge> edge) {
    for (const HalfEdge& use : edge) middle(use.triangle, use.corner) = next;
    ++next;
  });
  for (std::int32_t& vertex : middle.reshaped<Eigen::RowMajor>()) {
    if (vertex < 0) vertex = next++;
  }
  Shape result;
  result.vertices.resize(next, 3);
  result.vertices.topRows(corners) = mesh.vertices;
  result.triangles.resize(4 * mesh.triangles.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = mesh.triangles.row(t);
    const auto side = middle.row(t);
    for (int k = 0; k < 3; ++k) {
      result.vertices.row(side[k]) = (mesh.vertices.row(corner[k]) + mesh.vertices.row(corner[(k + 1) % 3])) / 2;
    }
    result.triangles.middleRows(4 * t, 4) << side[0], side[1], side[2],  //
        corner[0], side[0], side[2],                                     //
        side[0], corner[1], side[1],                                     //
        side[2], side[1], corner[2];
  }
  return result;
}

bool is_cracked(const Shape& mesh) {
  std::size_t edges = 0;
  std::size_t open = 0;
  for_each_edge(half_edges(mesh.triangles, welded_vertices(mesh.vertices)), [&](std::span<const HalfEdge> uses) {
    ++edges;
    open += uses.size() == 1 ? 1 : 0;
  });
  return static_cast<double>(open) > max_open_edges * static_cast<double>(edges);
}

SegmentationProxy itself(const Shape& shape) {
  SegmentationProxy result{.shape = shape, .node_of = {}};
  result.node_of.resize(static_cast<std::size_t>(is_cloud(shape) ? shape.vertices.rows() : shape.triangles.rows()));
  std::iota(result.node_of.begin(), result.node_of.end(), 0);
  return result;
}

SegmentationProxy refined(const Shape& mesh) {
  SegmentationProxy result = itself(mesh);
  while (result.shape.triangles.rows() < min_triangles) {
    result.shape = cut_into_four(result.shape);
    for (std::int32_t& node : result.node_of) node *= 4;  // the middle one of the four
  }
  return result;
}

}  // namespace

std::vector<std::int32_t> SegmentationProxy::transfer(std::span<const std::int32_t> labels) const {
  std::vector<std::int32_t> carried;
  carried.reserve(node_of.size());
  for (const std::int32_t node : node_of) carried.push_back(labels[static_cast<std::size_t>(node)]);
  return carried;
}

SegmentationProxy segmentation_proxy(const Shape& shape) {
  if (is_cloud(shape) || shape.triangles.rows() == 0) return itself(shape);
  SegmentationProxy result = refined(shape);
  if (!is_cracked(result.shape)) return result;
  RandomNumbers random(1);
  result.shape = sample_points(shape, {.points = points_of_cracked}, random);
  result.node_of = nearest_points(sample_shape(shape, SampleSite::faces).points, result.shape.vertices);
  return result;
}

}  // namespace shapegauge

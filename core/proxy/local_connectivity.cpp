// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/proxy/local_connectivity.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shapegauge {

LocalConnectivity::LocalConnectivity(const Shape& shape, std::span<const std::int32_t> merged,
                                     std::span<const HalfEdge> uses)
    : spheres_(4, shape.triangles.rows()),
      on_border_(static_cast<std::size_t>(shape.triangles.rows()), 0),
      visited_by_(on_border_.size(), 0) {
  for (Eigen::Index t = 0; t < spheres_.cols(); ++t) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = shape.vertices.row(shape.triangles(t, k)).transpose();
    // The centre of the box does not depend on the order of corners.
    const Eigen::Vector3d centre = (corners.rowwise().minCoeff() + corners.rowwise().maxCoeff()) / 2;
    spheres_.col(t) << centre, std::sqrt((corners.colwise() - centre).colwise().squaredNorm().maxCoeff());
  }
  DisjointSets pieces;
  pieces.grow_to(on_border_.size());
  std::vector<Neighbour> pairs;
  pairs.reserve(uses.size());
  for_each_edge(uses, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1) on_border_[at(edge.front().triangle)] = 1;
    for (std::size_t k = 1; k < edge.size(); ++k) {
      const std::int32_t a = edge[k - 1].triangle;
      const std::int32_t b = edge[k].triangle;
      pairs.push_back({a, b});
      pairs.push_back({b, a});
      pieces.join(a, b);
    }
  });
  across_edges_ = bucket_sort(pairs, on_border_.size(), [](const Neighbour& pair) { return pair.of; });
  for (std::size_t t = 0; t < on_border_.size(); ++t) component_.push_back(pieces.find(static_cast<std::int32_t>(t)));
  if (std::ranges::count(on_border_, 1) > 0) set_fans(shape, merged);
}

void LocalConnectivity::set_fans(const Shape& shape, std::span<const std::int32_t> merged) {
  std::vector<Neighbour> corners;
  corners.reserve(3 * on_border_.size());
  for (Eigen::Index t = 0; t < shape.triangles.rows(); ++t) {
    for (int k = 0; k < 3; ++k) corners.push_back({merged[at(shape.triangles(t, k))], static_cast<std::int32_t>(t)});
  }
  fans_ = bucket_sort(corners, merged.size(), [](const Neighbour& corner) { return corner.of; });
  fan_used_by_.assign(merged.size(), 0);
  corners_.reserve(on_border_.size());
  for (std::size_t t = 0; t < on_border_.size(); ++t) {
    corners_.push_back({corners[3 * t].of, corners[3 * t + 1].of, corners[3 * t + 2].of});
  }
}

std::span<const LocalConnectivity::Neighbour> LocalConnectivity::of(const Neighbours& neighbours, std::int32_t key) {
  const std::size_t first = neighbours.first[at(key)];
  return std::span(neighbours.values).subspan(first, neighbours.first[at(key) + 1] - first);
}

void LocalConnectivity::visit(std::int32_t triangle) {
  visited_by_[at(triangle)] = search_;
  has_visited_boundary_ = has_visited_boundary_ || on_border_[at(triangle)] != 0;
  queue_.push_back(triangle);
}

/// Calls use(neighbour) for the neighbours of a triangle, those about a vertex only once for the same mark: a fan of n
/// triangles has n^2 pairs of neighbours.
template <typename Use>
void LocalConnectivity::for_each_neighbour(std::int32_t triangle, SharedElement shared, std::int32_t mark, Use use) {
  if (shared == SharedElement::edge) {
    for (const Neighbour& neighbour : of(across_edges_, triangle)) use(neighbour.triangle);
    return;
  }
  for (const std::int32_t vertex : corners_[at(triangle)]) {
    if (std::exchange(fan_used_by_[at(vertex)], mark) == mark) continue;
    for (const Neighbour& neighbour : of(fans_, vertex)) use(neighbour.triangle);
  }
}

/// Walks greedily to the neighbour in the ball nearest to the target, as long as the distance decreases.
void LocalConnectivity::walk_towards(std::int32_t to, const Eigen::Vector3d& centre, double radius,
                                     SharedElement shared) {
  const Eigen::Vector3d target = spheres_.col(to).head<3>();
  double nearest = (spheres_.col(queue_.back()).head<3>() - target).squaredNorm();
  for (std::int32_t here = queue_.back(); here != to;) {
    std::int32_t best = -1;
    for_each_neighbour(here, shared, -search_, [&](std::int32_t neighbour) {
      const double distance = (spheres_.col(neighbour).head<3>() - target).squaredNorm();
      if (!(distance < nearest) || !meets(neighbour, centre, radius)) return;
      nearest = distance;
      best = neighbour;
    });
    if (best < 0) return;
    visit(best);
    here = best;
  }
}

bool LocalConnectivity::connected_in_ball(std::int32_t from, std::int32_t to, const Eigen::Vector3d& centre,
                                          double radius, SharedElement shared) {
  ++search_;
  has_visited_boundary_ = false;
  queue_.clear();
  visit(from);
  walk_towards(to, centre, radius, shared);
  for (std::size_t next = 0; next < queue_.size() && !visited(to); ++next) {
    for_each_neighbour(queue_[next], shared, search_, [&](std::int32_t neighbour) {
      if (!visited(neighbour) && meets(neighbour, centre, radius)) visit(neighbour);
    });
  }
  return visited(to);
}

}  // namespace shapegauge

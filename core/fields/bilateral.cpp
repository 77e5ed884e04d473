// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/fields/bilateral.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <tbb/enumerable_thread_specific.h>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

namespace {

/// By sample: its adjacent samples.
using Adjacency = std::vector<std::vector<std::int32_t>>;

void join(Adjacency& adjacency, std::int32_t a, std::int32_t b) {
  adjacency[static_cast<std::size_t>(a)].push_back(b);
  adjacency[static_cast<std::size_t>(b)].push_back(a);
}

Adjacency adjacency_of(const Shape& shape, const Samples& samples) {
  Adjacency adjacency(static_cast<std::size_t>(samples.points.rows()));
  if (is_cloud(shape) || samples.site == SampleSite::surface) {
    constexpr Eigen::Index neighbours = 8;
    const PointNeighbours nearest = nearest_neighbours(samples.points, neighbours);
    for (Eigen::Index i = 0; i < nearest.indices.rows(); ++i) {
      for (const std::int32_t other : nearest.indices.row(i)) join(adjacency, static_cast<std::int32_t>(i), other);
    }
  } else {
    const bool at_faces = samples.site == SampleSite::faces;
    const std::vector<std::int32_t> merged = welded_vertices(shape.vertices);
    for_each_edge(half_edges(shape.triangles, merged), [&](std::span<const HalfEdge> edge) {
      if (!at_faces) join(adjacency, edge.front().low, edge.front().high);
      for (std::size_t i = 1; at_faces && i < edge.size(); ++i) {
        join(adjacency, edge[i - 1].triangle, edge[i].triangle);
      }
    });
    for (std::size_t v = 0; !at_faces && v < merged.size(); ++v) {
      const auto vertex = static_cast<std::int32_t>(v);
      if (merged[v] != vertex) join(adjacency, merged[v], vertex);
    }
  }
  for (auto& of_sample : adjacency) {
    std::ranges::sort(of_sample);
    of_sample.erase(std::unique(of_sample.begin(), of_sample.end()), of_sample.end());
  }
  return adjacency;
}

/// Dijkstra's algorithm, limited to paths within reach.
class Vicinity {
 public:
  Vicinity(const Points& points, const Adjacency& adjacency)
      : points_(points), adjacency_(adjacency), distance_(adjacency.size(), infinity) {}

  /// Calls visit(sample, distance) for the sample itself and all samples within reach.
  template <typename Visit>
  void around(std::int32_t sample, double reach, Visit visit) {
    using Entry = std::pair<double, std::int32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto offer = [&](std::int32_t to, double distance) {
      double& known = distance_[static_cast<std::size_t>(to)];
      if (!(distance < known) || distance > reach) return;
      if (known == infinity) touched_.push_back(to);
      known = distance;
      open.emplace(distance, to);
    };
    offer(sample, 0);
    while (!open.empty()) {
      const auto [distance, from] = open.top();
      open.pop();
      if (distance > distance_[static_cast<std::size_t>(from)]) continue;
      visit(from, distance);
      for (const std::int32_t to : adjacency_[static_cast<std::size_t>(from)]) {
        offer(to, distance + (points_.row(to) - points_.row(from)).norm());
      }
    }
    for (const std::int32_t reached : touched_) distance_[static_cast<std::size_t>(reached)] = infinity;
    touched_.clear();
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  const Points& points_;
  const Adjacency& adjacency_;
  std::vector<double> distance_;
  std::vector<std::int32_t> touched_;
};

/// Returns the weighted standard deviation of the valid values.
double deviation_of(const ScalarField& field) {
  const Eigen::ArrayXd counts = field.values.array().isFinite().select(field.weights.array(), 0.0);
  const Eigen::ArrayXd values = field.values.array().isFinite().select(field.values.array(), 0.0);
  const double total = counts.sum();
  if (!(total > 0)) return 0;
  const double mean = (counts * values).sum() / total;
  return std::sqrt((counts * (values - mean).square()).sum() / total);
}

void check_size(const Shape& shape, const Samples& samples, const ScalarField& field) {
  const Eigen::Index count = samples.points.rows();
  const Eigen::Index sites = samples.site == SampleSite::faces ? shape.triangles.rows() : shape.vertices.rows();
  if (field.values.size() == count && field.weights.size() == count &&
      (samples.site == SampleSite::surface || is_cloud(shape) || sites == count)) {
    return;
  }
  throw InputError(fmt::format("the field does not match the samples: {} values and {} weights for {} samples",
                               field.values.size(), field.weights.size(), count));
}

}  // namespace

ScalarField bilateral_smoothing(const Shape& shape, const Samples& samples, ScalarField field,
                                const BilateralOptions& options) {
  check_options("bilateral", bilateral_table, options);
  require_usable(shape);
  check_size(shape, samples, field);
  const double value_width = options.value_width * deviation_of(field);
  const double spatial_width = options.spatial_width * std::sqrt(field.weights.sum());
  if (options.iterations == 0 || !(value_width > 0) || !(spatial_width > 0)) return field;
  const Adjacency adjacency = adjacency_of(shape, samples);
  // Duplicate triangles have no neighbours; each gets the value of its first.
  const std::vector<std::int32_t> doubles_of_faces =
      samples.site == SampleSite::faces && !is_cloud(shape)
          ? first_duplicates(shape.triangles, welded_vertices(shape.vertices))
          : std::vector<std::int32_t>();
  tbb::enumerable_thread_specific<Vicinity> vicinities([&] { return Vicinity(samples.points, adjacency); });
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const Eigen::VectorXd before = field.values;
    parallel_for(Eigen::Index{0}, before.size(), [&](Eigen::Index i) {
      if (!std::isfinite(before[i])) return;
      double sum = 0;
      double total = 0;
      vicinities.local().around(static_cast<std::int32_t>(i), 2 * spatial_width, [&](std::int32_t j, double distance) {
        if (!std::isfinite(before[j])) return;
        const double by_distance = distance / spatial_width;
        const double by_value = (before[j] - before[i]) / value_width;
        const double weight = field.weights[j] * std::exp(-0.5 * (by_distance * by_distance + by_value * by_value));
        sum += weight * before[j];
        total += weight;
      });
      if (total > 0) field.values[i] = sum / total;
    });
    if (!doubles_of_faces.empty()) field.values = field.values(doubles_of_faces).eval();
  }
  return field;
}

}  // namespace shapegauge

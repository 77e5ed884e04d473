// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/patches.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <queue>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/random_numbers.h"

namespace shapegauge {

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

/// Shortest paths from centres, which may be added incrementally.
class Growth {
 public:
  Growth(const SurfaceGraph& graph, std::span<const double> costs)
      : patch(static_cast<std::size_t>(graph.size()), -1),
        cost(static_cast<std::size_t>(graph.size()), unreached),
        graph_(graph),
        costs_(costs) {}

  void start_at(std::int32_t centre, std::int32_t number) { reach(centre, 0, number); }

  /// Propagates from the centres added since the last call. Ties go to the earlier patch.
  void spread() {
    const SparseInterruptionCheck check;
    while (!queue_.empty()) {
      check();
      const auto [way, node] = queue_.top();
      queue_.pop();
      if (way > cost[static_cast<std::size_t>(node)]) continue;
      for (std::size_t i = graph_.first[static_cast<std::size_t>(node)];
           i < graph_.first[static_cast<std::size_t>(node) + 1]; ++i) {
        const double step = costs_.empty() ? graph_.links[i].distance : costs_[i];
        reach(graph_.links[i].to, way + step, patch[static_cast<std::size_t>(node)]);
      }
    }
  }

  std::vector<std::int32_t> patch;
  std::vector<double> cost;

 private:
  void reach(std::int32_t node, double way, std::int32_t number) {
    const auto n = static_cast<std::size_t>(node);
    if (!(way < cost[n])) return;
    cost[n] = way;
    patch[n] = number;
    queue_.emplace(way, node);
  }

  using Reached = std::pair<double, std::int32_t>;
  const SurfaceGraph& graph_;
  std::span<const double> costs_;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue_;
};

std::vector<std::int32_t> farthest_centres(const SurfaceGraph& graph, const PatchOptions& options,
                                           std::span<const double> costs) {
  Growth growth(graph, costs);
  std::vector<std::int32_t> centres;
  const auto add = [&](std::int32_t centre) {
    growth.start_at(centre, static_cast<std::int32_t>(centres.size()));
    growth.spread();
    centres.push_back(centre);
  };
  RandomNumbers random(options.seed);
  add(static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(graph.size()))));
  // Every component gets a centre before any gets two.
  for (std::int32_t node = 0; node < graph.size(); ++node) {
    if (growth.cost[static_cast<std::size_t>(node)] == unreached) add(node);
  }
  while (std::ssize(centres) < options.count) {
    check_interruption();
    const auto farthest = std::ranges::max_element(growth.cost);
    if (!(*farthest > 0)) break;
    add(static_cast<std::int32_t>(farthest - growth.cost.begin()));
  }
  return centres;
}

/// Returns the node of each patch closest to its mean position.
std::vector<std::int32_t> middles(const SurfaceGraph& graph, const std::vector<std::int32_t>& patch,
                                  std::size_t count) {
  const Samples& samples = graph.samples;
  Points means = Points::Zero(static_cast<Eigen::Index>(count), 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(means.rows());
  const double smallest = std::numeric_limits<double>::min();
  for (std::int32_t node = 0; node < graph.size(); ++node) {
    const std::int32_t p = patch[static_cast<std::size_t>(node)];
    const double weight = std::max(samples.weights[node], smallest);
    weights[p] += weight;
    means.row(p) += (samples.points.row(node) - means.row(p)) * (weight / weights[p]);
  }
  std::vector<std::int32_t> result(count, -1);
  std::vector<double> best(count, unreached);
  for (std::int32_t node = 0; node < graph.size(); ++node) {
    const auto p = static_cast<std::size_t>(patch[static_cast<std::size_t>(node)]);
    const double distance = (samples.points.row(node) - means.row(static_cast<Eigen::Index>(p))).squaredNorm();
    if (distance < best[p]) {
      best[p] = distance;
      result[p] = node;
    }
  }
  return result;
}

std::vector<std::int32_t> grown_from(const SurfaceGraph& graph, std::span<const double> costs,
                                     const std::vector<std::int32_t>& centres) {
  Growth growth(graph, costs);
  for (std::size_t i = 0; i < centres.size(); ++i) growth.start_at(centres[i], static_cast<std::int32_t>(i));
  growth.spread();
  return std::move(growth.patch);
}

}  // namespace

std::vector<std::int32_t> patches(const SurfaceGraph& graph, const PatchOptions& options,
                                  std::span<const double> costs) {
  if (options.count < 1)
    throw InputError(fmt::format("the number of patches must be at least 1, not {}", options.count));
  if (!costs.empty() && costs.size() != graph.links.size()) {
    throw ArgumentError(
        fmt::format("there are {} costs for {} links of the surface", costs.size(), graph.links.size()));
  }
  std::vector<std::int32_t> centres = farthest_centres(graph, options, costs);
  std::vector<std::int32_t> patch = grown_from(graph, costs, centres);
  for (int round = 0; round < 3; ++round) {
    centres = middles(graph, patch, centres.size());
    patch = grown_from(graph, costs, centres);
  }
  return patch;
}

}  // namespace shapegauge

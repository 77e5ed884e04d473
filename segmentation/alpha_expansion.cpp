// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/alpha_expansion.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <maxflow.h>
#include <stdexcept>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"

namespace shapegauge {

namespace {

using Flow = maxflow::Graph<double, double, double>;

/// Error handler of the library, which would otherwise terminate the program.
void report(const char* message) { throw std::runtime_error(message); }

void check(const Eigen::MatrixXd& costs, const std::vector<LabelEdge>& edges, std::span<const std::int32_t> labels) {
  if (costs.rows() != std::ssize(labels)) {
    throw ArgumentError("there are " + std::to_string(costs.rows()) + " rows of costs for the labels of " +
                        std::to_string(labels.size()) + " nodes");
  }
  if (costs.rows() > std::numeric_limits<int>::max()) {
    throw ArgumentError("there are " + std::to_string(costs.rows()) + " nodes to label; at most " +
                        std::to_string(std::numeric_limits<int>::max()) + " are supported");
  }
  if (!costs.allFinite()) {
    throw ArgumentError(
        "costs of labels must be finite numbers (not finite: " + std::to_string((!costs.array().isFinite()).count()) +
        " of " + std::to_string(costs.size()) + ")");
  }
  for (const std::int32_t label : labels) {
    if (label < 0 || label >= costs.cols()) {
      throw ArgumentError("the initial label of a node is " + std::to_string(label) + "; it must be from 0 to " +
                          std::to_string(costs.cols() - 1));
    }
  }
  const auto is_node = [&](std::int32_t node) { return node >= 0 && node < costs.rows(); };
  for (const LabelEdge& edge : edges) {
    if (!is_node(edge.a) || !is_node(edge.b)) {
      throw ArgumentError("an edge joins the nodes " + std::to_string(edge.a) + " and " + std::to_string(edge.b) +
                          ", but there are " + std::to_string(costs.rows()) + ", numbered from 0");
    }
    if (!(edge.cost >= 0 && std::isfinite(edge.cost))) {
      throw ArgumentError("the cost of an edge is " + std::to_string(edge.cost) + "; it must be finite and at least 0");
    }
  }
}

/// Returns the labels after the optimal expansion of one label. Nodes on the sink's side of the cut change.
std::vector<std::int32_t> expanded(const Eigen::MatrixXd& costs, const std::vector<LabelEdge>& edges,
                                   std::vector<std::int32_t> labels, std::int32_t label) {
  Flow flow(static_cast<int>(costs.rows()), static_cast<int>(edges.size()), report);
  flow.add_node(static_cast<int>(costs.rows()));
  for (Eigen::Index node = 0; node < costs.rows(); ++node) {
    flow.add_tweights(static_cast<int>(node), costs(node, label), costs(node, labels[static_cast<std::size_t>(node)]));
  }
  for (const LabelEdge& edge : edges) {
    // Kolmogorov and Zabih 2004: the cost of two nodes is split into costs of each and one of the pair (stay, change).
    const std::int32_t a = labels[static_cast<std::size_t>(edge.a)];
    const std::int32_t b = labels[static_cast<std::size_t>(edge.b)];
    const double stay_stay = a != b ? edge.cost : 0;
    const double stay_change = a != label ? edge.cost : 0;
    const double change_stay = b != label ? edge.cost : 0;
    flow.add_tweights(edge.a, change_stay, stay_stay);
    flow.add_tweights(edge.b, 0, change_stay);
    flow.add_edge(edge.a, edge.b, stay_change + change_stay - stay_stay, 0);
  }
  flow.maxflow();
  for (Eigen::Index node = 0; node < costs.rows(); ++node) {
    if (flow.what_segment(static_cast<int>(node)) == Flow::SINK) labels[static_cast<std::size_t>(node)] = label;
  }
  return labels;
}

}  // namespace

double labelling_cost(std::span<const std::int32_t> labels, const Eigen::MatrixXd& costs,
                      const std::vector<LabelEdge>& edges) {
  check(costs, edges, labels);
  double sum = 0;
  for (Eigen::Index node = 0; node < costs.rows(); ++node) sum += costs(node, labels[static_cast<std::size_t>(node)]);
  for (const LabelEdge& edge : edges) {
    if (labels[static_cast<std::size_t>(edge.a)] != labels[static_cast<std::size_t>(edge.b)]) sum += edge.cost;
  }
  return sum;
}

std::vector<std::int32_t> alpha_expansion(const Eigen::MatrixXd& costs, const std::vector<LabelEdge>& edges,
                                          std::vector<std::int32_t> start) {
  constexpr int max_rounds = 20;
  std::vector<std::int32_t> labels = std::move(start);
  double cost = labelling_cost(labels, costs, edges);
  for (int round = 0; round < max_rounds; ++round) {
    bool gained = false;
    for (std::int32_t label = 0; label < costs.cols(); ++label) {
      check_interruption();
      std::vector<std::int32_t> next = expanded(costs, edges, labels, label);
      const double next_cost = labelling_cost(next, costs, edges);
      // The gain must exceed rounding: otherwise labels of equal cost could alternate for ever.
      if (!(next_cost < cost - 1e-12 * std::abs(cost))) continue;
      labels = std::move(next);
      cost = next_cost;
      gained = true;
    }
    if (!gained) break;
  }
  return labels;
}

}  // namespace shapegauge

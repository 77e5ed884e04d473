// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace shapegauge {

/// Edge of the graph to be labelled: a pair of nodes and the cost of giving them different labels.
struct LabelEdge {
  std::int32_t a = 0;  ///< index of one node of the pair
  std::int32_t b = 0;  ///< index of the other node of the pair
  double cost = 0;     ///< cost if the two nodes have different labels, at least 0
};

/// Computes the cost of a labelling: the sum of costs(node, label of the node) over all nodes, plus the costs of the
/// edges whose two nodes have different labels. `costs` is nodes x labels.
double labelling_cost(std::span<const std::int32_t> labels, const Eigen::MatrixXd& costs,
                      const std::vector<LabelEdge>& edges);

/// Finds a labelling of low cost by alpha-expansion: each label in turn expands by the optimal set of nodes, a minimum
/// cut (Boykov, Veksler, Zabih 2001; cuts after Boykov and Kolmogorov 2004). Stops when no label can gain, or after
/// 20 rounds over all labels. The cost never exceeds that of `start`. On convergence, the edges contribute at
/// most twice their optimal cost. Optimal for two labels.
///
/// `costs` is nodes x labels; `start` has one label per node, as the result has. Throws ArgumentError for a label or a
/// node out of range, an edge cost that is negative, a cost that is not finite, and sizes that do not match.
std::vector<std::int32_t> alpha_expansion(const Eigen::MatrixXd& costs, const std::vector<LabelEdge>& edges,
                                          std::vector<std::int32_t> start);

}  // namespace shapegauge

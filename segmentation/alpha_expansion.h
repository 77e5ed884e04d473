#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace shapegauge {

/// Two nodes that should have the same label, and what it costs if they have not.
struct LabelEdge {
  std::int32_t a = 0;
  std::int32_t b = 0;
  double cost = 0;  ///< at least 0
};

/// What a labelling costs: costs(node, label) of all nodes, and the edges whose ends have different labels.
double labelling_cost(std::span<const std::int32_t> labels, const Eigen::MatrixXd& costs,
                      const std::vector<LabelEdge>& edges);

/// A labelling of low cost, by alpha-expansion: for one label after the other, any nodes may change to it, and the best
/// change of this kind is a minimum cut (Boykov, Veksler, Zabih 2001; the cut after Boykov and Kolmogorov 2004). It
/// ends when no label can gain, or after so many rounds over all labels. The cost is at most that of the start and, at
/// the end of the last round, at most twice the least possible one as far as edges go. Of two labels it is the least.
///
/// `start` has a label for each node. Throws ArgumentError: a label or a node out of range, a cost that is
/// negative (of an edge) or not finite, sizes that differ.
std::vector<std::int32_t> alpha_expansion(const Eigen::MatrixXd& costs, const std::vector<LabelEdge>& edges,
                                          std::vector<std::int32_t> start, int rounds = 20);

}  // namespace shapegauge

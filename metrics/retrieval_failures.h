// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// Computes the confusion matrix of nearest-neighbour classification (classes x classes): entry (a, b) is the number of
/// queries of class a whose nearest neighbour is of class b. labels[i], in [0, classes), is the class of model i,
/// nearest[i] the index of its nearest neighbour; `queries` are indices of models. Throws ArgumentError for a label, a
/// model or a query out of range.
Eigen::MatrixXi confusion_matrix(std::span<const std::int32_t> nearest, std::span<const int> labels,
                                 std::span<const Eigen::Index> queries, int classes);

/// Returns the `count` queries with the lowest scores by a measure, in ascending order (ties: in the order of queries),
/// as positions in Evaluation::queries; all queries if there are fewer. Throws ArgumentError if the evaluation lacks
/// the measure.
std::vector<std::size_t> worst_queries(const Evaluation& evaluation, std::string_view measure, std::size_t count);

}  // namespace shapegauge

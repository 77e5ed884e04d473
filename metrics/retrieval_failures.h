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

/// Computes the confusion matrix: entry (a, b) is the number of queries of class a whose nearest neighbour is of class
/// b. labels[i], in [0, classes), is the class of model i; nearest[i] is the model nearest to it; `queries` are models.
/// Throws ArgumentError for a label, a model or a query out of range.
Eigen::MatrixXi confusion_matrix(std::span<const std::int32_t> nearest, std::span<const int> labels,
                                 std::span<const Eigen::Index> queries, int classes);

/// Returns the `count` queries with the lowest values of a measure, in ascending order (ties: in the queries' order),
/// as positions in Evaluation::queries; all if there are no more. Throws ArgumentError if the evaluation lacks the
/// measure.
std::vector<std::size_t> worst_queries(const Evaluation& evaluation, std::string_view measure, std::size_t count);

}  // namespace shapegauge

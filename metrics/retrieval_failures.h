#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// Entry (a, b): the number of queries of class a whose nearest neighbour is of class b. labels[i], from 0 to less than
/// `classes`, is the class of model i, nearest[i] the model nearest to it; `queries` are models. Throws
/// ArgumentError for a label, a model or a query out of range.
Eigen::MatrixXi confusion_matrix(std::span<const std::int32_t> nearest, std::span<const int> labels,
                                 std::span<const Eigen::Index> queries, int classes);

/// The `count` queries with the lowest values of a measure, the lowest first and equals in their order, as positions in
/// Evaluation::queries; all of them where there are no more. Throws ArgumentError where the evaluation has no
/// measure of that name.
std::vector<std::size_t> worst_queries(const Evaluation& evaluation, std::string_view measure, std::size_t count);

}  // namespace shapegauge

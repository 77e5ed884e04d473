#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// Entry (a, b): the number of queries of class a whose nearest neighbour, the first of ranked_models(), is of class b.
/// labels[i], from 0 to less than `classes`, is the class of model i; `queries` are rows of the matrix. Parallel over
/// queries. Throws std::invalid_argument for a label or a query out of range, a matrix of another size than labels, and
/// fewer than two models.
Eigen::MatrixXi confusion_matrix(const DistanceTable& distances, std::span<const int> labels,
                                 std::span<const Eigen::Index> queries, int classes);

/// The `count` queries with the lowest values of a measure, the lowest first and equals in their order, as positions in
/// Evaluation::queries; all of them where there are no more. Throws std::invalid_argument where the evaluation has no
/// measure of that name.
std::vector<std::size_t> worst_queries(const Evaluation& evaluation, std::string_view measure, std::size_t count);

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/metrics/distance_table.h"

namespace shapegauge {

/// Entry (a, b): the number of queries of class a whose nearest neighbour, the first of ranked_models(), is of class b.
/// labels[i], from 0 to less than `classes`, is the class of model i; `queries` are rows of the matrix. Parallel over
/// queries. Throws std::invalid_argument for a label or a query out of range, a matrix of another size than labels, and
/// fewer than two models.
Eigen::MatrixXi confusion_matrix(const DistanceTable& distances, std::span<const int> labels,
                                 std::span<const Eigen::Index> queries, int classes);

}  // namespace shapegauge

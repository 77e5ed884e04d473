#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Histograms of several fields of one shape, side by side, divided by their total so that the whole sums to 1. Each
/// part keeps its share of the total: k histograms that sum to 1 each weigh 1/k, however many bins they have, and the
/// L1 distance of two such signatures is the mean of the parts' distances. Multiply a part beforehand to give it
/// another weight. Throws std::invalid_argument where there are no parts, or an entry is negative or not finite, or all
/// are 0.
Eigen::VectorXf concatenate(std::span<const Eigen::VectorXf> parts);

/// The same for many shapes at once: row i is the concatenation of the parts' rows i. Throws std::invalid_argument as
/// above, and where the parts differ in their number of rows.
Signatures concatenate(std::span<const Signatures> parts);

}  // namespace shapegauge

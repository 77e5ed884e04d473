#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/metrics/protocol.h"

namespace shapegauge::naive {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The six measures NN, FT, ST, E, DCG, mAP of one query, by the formulas of the design, section 4, taken literally and
/// one protocol at a time. Shares nothing with the library but the definitions: no sorting, no list, no reuse between
/// measures; the rank of a model is found by counting the models before it.
std::vector<double> measures_of(const Matrix& distances, const std::vector<int>& labels, int query, Protocol protocol);

/// Precision at the protocol's recall levels, as literally. Under psb nothing (NaN) below the first hit.
std::vector<double> precisions_of(const Matrix& distances, const std::vector<int>& labels, int query,
                                  Protocol protocol);

}  // namespace shapegauge::naive

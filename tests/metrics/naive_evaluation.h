#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "shapegauge/metrics/protocol.h"

namespace shapegauge::naive {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The names of the measures that measures_of gives, as the library knows them.
std::vector<std::string> measure_names();

/// The measures of one query, by the formulas of docs/reference/definitions.md#measures and of trec_eval, taken
/// literally and one protocol at a time. Shares nothing with the library but the definitions: no sorting, no list, no
/// reuse between measures; the rank of a model is found by counting the models before it. Models at equal distance come
/// in the order of tie_order[model], which are different numbers, or by index where it is empty.
std::vector<double> measures_of(const Matrix& distances, const std::vector<int>& labels, int query, Protocol protocol,
                                const std::vector<int>& tie_order = {});

/// Precision at the protocol's recall levels, as literally. Under psb nothing (NaN) below the first hit.
std::vector<double> precisions_of(const Matrix& distances, const std::vector<int>& labels, int query,
                                  Protocol protocol);

}  // namespace shapegauge::naive

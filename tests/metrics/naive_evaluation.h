// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "shapegauge/metrics/protocol.h"

namespace shapegauge::naive {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Names of the measures returned by measures_of, as in the library.
std::vector<std::string> measure_names();

/// Measures of one query, by direct evaluation of the formulas of docs/reference/definitions.md#measures and
/// trec_eval, one protocol at a time. Shares no code with the library: no sorting, no list, no
/// reuse between measures; the rank of a model is found by counting the models before it. Models at equal distance come
/// in increasing order of tie_order[model] (distinct numbers), or by index if it is empty.
std::vector<double> measures_of(const Matrix& distances, const std::vector<int>& labels, int query, Protocol protocol,
                                const std::vector<int>& tie_order = {});

/// Precision at the protocol's recall levels, by direct evaluation. Under psb, NaN below the first hit.
std::vector<double> precisions_of(const Matrix& distances, const std::vector<int>& labels, int query,
                                  Protocol protocol);

}  // namespace shapegauge::naive

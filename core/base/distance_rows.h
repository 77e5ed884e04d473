// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

namespace shapegauge {

/// Matrix of distances between models, row-major: entry (i, j) is the distance from query model i to model j.
/// Rows and columns are the same models in the same order, unless a function says otherwise.
using DistanceMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// Non-owning view of a distance matrix.
using DistanceTable = Eigen::Ref<const DistanceMatrix>;

/// Function that returns `count` rows of a distance matrix, from row `first` on. The whole matrix need not be in
/// memory.
using RowSource = std::function<DistanceMatrix(Eigen::Index first, Eigen::Index count)>;

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// Distances, row-major: entry (i, j) is the distance from query i to model j.
using DistanceTableRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// A matrix of distances that is someone else's.
using DistanceTable = Eigen::Ref<const DistanceTableRows>;

}  // namespace shapegauge

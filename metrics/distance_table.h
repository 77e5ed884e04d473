#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// Row-major square matrix of distances: entry (i, j) is the distance from query i to model j.
using DistanceTable = Eigen::Ref<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

}  // namespace shapegauge

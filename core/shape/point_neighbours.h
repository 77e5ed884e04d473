#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The k nearest neighbours of each of n points.
struct PointNeighbours {
  /// n x k indices, nearest first; the point itself is left out, another point at the same place is not.
  Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> indices;
  /// n x k distances to them.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> distances;
};

/// Finds the neighbours with a k-d tree (nanoflann), in parallel in the calling TBB arena. k is lowered to n - 1 where
/// there are no more. Of neighbours at the same distance, any may be the k-th: the tree decides, the same way for the
/// same points in the same order.
PointNeighbours nearest_neighbours(const Points& points, Eigen::Index k);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// Maximum number of cells along a side of the heat map of a distance matrix.
inline constexpr Eigen::Index max_heat_map_side = 1000;

/// Indices of the nearest other models, nearest first; one row per model.
using NearestIndices = Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Summary of a distance matrix between models for display: a heat map and the nearest neighbours of each model.
struct DistanceOverview {
  Eigen::Index block = 1;  ///< number of models along each side of a heat-map cell; 1 up to max_heat_map_side models
  /// Heat map with rows and columns in order_by_class(). Each cell is the mean of the finite entries of a block x block
  /// part of the matrix, or infinity if no entry is finite. The diagonal counts as 0.
  Eigen::MatrixXd cells;
  NearestIndices nearest;            ///< per model: indices of up to ten nearest other models (first_ranked())
  DistanceMatrix nearest_distances;  ///< per model: distances to the models in `nearest`
};

/// Accumulator of a DistanceOverview for a distance matrix streamed by rows.
struct OverviewAccumulator {
  /// Sum and number of the finite distances in a heat-map cell. The sum is a whole number of `unit`, so that it does
  /// not depend on the order of rows.
  struct Cell {
    std::int64_t sum = 0;    ///< sum of the finite distances in the cell, in multiples of `unit`
    std::int64_t count = 0;  ///< number of finite distances in the cell
  };

  double unit = 1;                      ///< distance that corresponds to 1 in Cell::sum, the resolution of the sums
  std::vector<std::int32_t> positions;  ///< per model: its position in order_by_class()
  std::vector<Cell> sums;     ///< sums of all heat-map cells, row-major; empty if each cell is a single matrix entry
  DistanceOverview overview;  ///< overview of the rows so far; `cells` is not set where `sums` is used
};

/// Returns the indices of the models sorted by class label, then by index. labels[i] is the class of model i.
std::vector<Eigen::Index> order_by_class(std::span<const int> labels);

/// Returns the largest finite |distance| in a row of a distance matrix, except for the diagonal entry row[itself]; 0 if
/// there is none.
double largest_finite(std::span<const double> row, Eigen::Index itself);

/// Creates the empty accumulator for a distance matrix between models with these class labels. `largest` is
/// largest_finite() of row 0. It sets the resolution of the sums and has no effect for up to max_heat_map_side models.
OverviewAccumulator begin_overview(std::span<const int> labels, double largest);

/// Adds consecutive rows of the distance matrix, the first of which is row `first`, to the accumulator `seen`.
/// Parallel; the result does not depend on the number of threads.
void accumulate(const DistanceTable& rows, Eigen::Index first, OverviewAccumulator& seen);

/// Returns the finished overview. Each row of the distance matrix must have been accumulated once.
DistanceOverview overview_of(OverviewAccumulator seen);

/// Computes the overview of a square distance matrix in memory. labels[i] is the class of model i.
DistanceOverview overview_of(const DistanceTable& distances, std::span<const int> labels);

}  // namespace shapegauge

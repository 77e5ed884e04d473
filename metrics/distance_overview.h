// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// Maximum number of cells along a side of the heat map of a distance matrix.
inline constexpr Eigen::Index largest_heat_map = 1000;

/// Indices of each model's nearest others.
using NearestIndices = Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Summary of a distance matrix between models: a heat map, and each model's nearest.
struct DistanceOverview {
  Eigen::Index block = 1;  ///< models along the side of a cell; 1 for up to largest_heat_map models
  /// Heat map with rows and columns in order_by_class(). Each cell is the mean of the finite entries of a block x block
  /// part of the matrix, or infinity without any. The diagonal counts as 0.
  Eigen::MatrixXd cells;
  NearestIndices nearest;            ///< per model: up to ten others, as first_ranked() returns them
  DistanceMatrix nearest_distances;  ///< distances to `nearest`
};

/// Overview of the rows of a matrix so far.
struct PartialOverview {
  /// Sum and number of the finite entries of a cell. The sum is an integer multiple of `unit`, which makes it
  /// independent of the order of rows.
  struct Cell {
    std::int64_t sum = 0;
    std::int64_t count = 0;
  };

  double unit = 1;
  std::vector<std::int32_t> positions;  ///< per model: its position in order_by_class()
  std::vector<Cell> sums;               ///< row by row; empty if a cell is one entry
  DistanceOverview overview;            ///< cells that are sums are missing
};

/// Returns the models' indices sorted by class, in the models' order within a class.
std::vector<Eigen::Index> order_by_class(std::span<const int> labels);

/// Returns the largest finite distance of a row without the model's distance to itself; 0 without any.
double largest_finite(std::span<const double> row, Eigen::Index itself);

/// Starts an overview of the matrix between models with these labels. `largest` is the largest_finite() of the first
/// row and sets the resolution of the sums; unused if cells are entries.
PartialOverview begin_overview(std::span<const int> labels, double largest);

/// Accumulates rows of the matrix from the row `first` on. Parallel, with the same result for any number of threads.
void accumulate(const DistanceTable& rows, Eigen::Index first, PartialOverview& seen);

/// Returns the overview after each row was accumulated once.
DistanceOverview overview_of(PartialOverview seen);

/// Computes the overview of a matrix in memory.
DistanceOverview overview_of(const DistanceTable& distances, std::span<const int> labels);

}  // namespace shapegauge

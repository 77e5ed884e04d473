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

/// Partial overview of some rows of a matrix. Several processes may each process other rows.
struct PartialOverview {
  /// Sum and number of the finite entries of a cell. The sum is an integer multiple of `unit`, which makes it
  /// independent of the order of rows and of their distribution over processes.
  struct Cell {
    std::int64_t sum = 0;
    std::int64_t count = 0;
  };

  Eigen::Index first = 0;
  double unit = 1;
  std::vector<std::int32_t> positions;  ///< per model: its position in order_by_class()
  Eigen::Index block = 1;
  Eigen::Index side = 0;        ///< number of cells along a side
  std::vector<Cell> sums;       ///< row by row; empty if a cell is one entry
  std::vector<double> entries;  ///< used instead of sums: rows from `first` on, in the models' order
  NearestIndices nearest;       ///< of the rows from `first` on
  DistanceMatrix nearest_distances;
};

/// Returns the models' indices sorted by class, in the models' order within a class.
std::vector<Eigen::Index> order_by_class(std::span<const int> labels);

/// Returns the largest finite distance of a row without the model's distance to itself; 0 without any.
double largest_finite(std::span<const double> row, Eigen::Index itself);

/// Starts an overview of the rows [first, last) of the matrix between models with these labels. `largest` is the
/// largest_finite() of the first row and sets the resolution of the sums; unused if cells are entries.
PartialOverview begin_overview(std::span<const int> labels, double largest, Eigen::Index first, Eigen::Index last);

/// Accumulates rows of the matrix from the row `first` on. Parallel, with the same result for any number of threads.
void accumulate(const DistanceTable& rows, Eigen::Index first, PartialOverview& seen);

/// Merges partial overviews. Each row must have been accumulated once.
DistanceOverview overview_of(std::span<const PartialOverview> parts);

/// Computes the overview of a matrix in memory.
DistanceOverview overview_of(const DistanceTable& distances, std::span<const int> labels);

}  // namespace shapegauge

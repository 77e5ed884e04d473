#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// The most cells along a side of the picture of a distance matrix.
inline constexpr Eigen::Index largest_heat_map = 1000;

/// By model the indices of its nearest others.
using NearestIndices = Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// What a reader sees of a distance matrix between models: a picture of it, and each model's nearest.
struct DistanceOverview {
  Eigen::Index block = 1;  ///< models along the side of a cell; 1 up to largest_heat_map models
  /// The picture, rows and columns in order_by_class(): each cell is the mean of a block x block part of the matrix, of
  /// its finite entries, infinity where there are none. A model's distance to itself counts as 0.
  Eigen::MatrixXd cells;
  NearestIndices nearest;            ///< by model up to ten others, as first_ranked() has them
  DistanceMatrix nearest_distances;  ///< of those
};

/// What was seen so far, of some rows of a matrix. Several processes may each see other rows of it.
struct SeenRows {
  /// Sum and number of the finite entries of a cell. The sum is a whole number of units: it does not depend on the
  /// order of the rows, nor on who has seen which.
  struct Cell {
    std::int64_t sum = 0;
    std::int64_t count = 0;
  };

  Eigen::Index first = 0;
  double unit = 1;
  std::vector<std::int32_t> places;  ///< by model, its place in order_by_class()
  Eigen::Index block = 1;
  Eigen::Index side = 0;        ///< cells along a side
  std::vector<Cell> sums;       ///< row by row; empty where a cell is one entry
  std::vector<double> entries;  ///< instead of sums: of the rows from `first` on, in the models' order
  NearestIndices nearest;       ///< of the rows from `first` on
  DistanceMatrix nearest_distances;
};

/// The models' indices, class by class, in the models' order within a class.
std::vector<Eigen::Index> order_by_class(std::span<const int> labels);

/// The largest finite distance of a row, that of the model to itself left out; 0 where there is none.
double largest_finite(std::span<const double> row, Eigen::Index itself);

/// Begins to look at the rows from `first` to before `last` of the matrix between models of these labels. `largest`:
/// largest_finite() of the first row, by which it is decided how fine the sums are; where cells are entries, it does
/// not matter.
SeenRows begin_overview(std::span<const int> labels, double largest, Eigen::Index first, Eigen::Index last);

/// Looks at rows of the matrix, from the row `first` on. In parallel, the same for any number of threads.
void look_at(const DistanceTable& rows, Eigen::Index first, SeenRows& seen);

/// What was seen of all rows, together. Each row must have been seen once.
DistanceOverview overview_of(std::span<const SeenRows> parts);

/// The overview of a matrix in memory.
DistanceOverview overview_of(const DistanceTable& distances, std::span<const int> labels);

}  // namespace shapegauge

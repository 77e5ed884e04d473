// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/retrieval/distance_matrix.h"

/// Nearest models of each model, shared by the re-ranking methods.
namespace shapegauge {

/// The k nearest other models of each of n models, with their distances.
struct NearestModels {
  /// Indices of the nearest models: n x k, nearest first (ties: smaller index first). -1 if fewer than k models are at
  /// a finite distance.
  Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> indices;
  DistanceMatrix distances;  ///< distances to the nearest models: n x k; infinite where the index is -1
  double largest = 0;        ///< largest finite distance between any two models
};

/// Model in a ranked answer to a query, with its distance from the query.
struct RankedModel {
  Eigen::Index model = 0;  ///< index of the model in the collection
  double distance = 0;     ///< distance between the query and the model
};

/// Makes a RowSource from a matrix in memory, which must outlive the result. Throws ArgumentError for a matrix that is
/// not square.
RowSource rows_of(const DistanceMatrix& distances);

/// Calls visit(first, block) for blocks of 256 rows of the distance matrix of `models` models, in order; `first` is the
/// index of a block's first row. Throws ArgumentError for a block of the wrong size.
template <typename Visit>
void for_each_block(Eigen::Index models, const RowSource& rows, Visit visit) {
  constexpr Eigen::Index rows_at_once = 256;
  for (Eigen::Index first = 0; first < models; first += rows_at_once) {
    const Eigen::Index count = std::min(rows_at_once, models - first);
    const DistanceMatrix block = rows(first, count);
    if (block.rows() != count || block.cols() != models) {
      throw ArgumentError("found rows of " + std::to_string(block.cols()) + " distances for " + std::to_string(models) +
                          " models");
    }
    visit(first, block);
  }
}

/// Throws ArgumentError, with the row and the column, for a distance that is negative or NaN. `first` is the index of
/// the first of these rows in the whole matrix. `of` names the matrix in the message, such as " of matrix 2", or is
/// empty.
void check_distances(const DistanceMatrix& rows, Eigen::Index first, const std::string& of = {});

/// Finds the k nearest other models of each model, at most `models` - 1, from the rows of the distance matrix. Throws
/// ArgumentError for a k below 1, for rows of the wrong length and for a distance that is negative or NaN.
NearestModels nearest_models(Eigen::Index models, int k, const RowSource& rows);

/// Returns the same nearest models with all distances multiplied by a factor.
NearestModels with_scaled_distances(NearestModels nearest, double factor);

/// Returns a power of two to multiply distances up to `largest` by, which protects their sums and quotients from
/// overflow and underflow; 1 if not needed.
double overflow_safe_factor(double largest);

/// Returns the mean of finite distances whose sum may overflow; NaN for an empty span.
double overflow_safe_mean(std::span<const double> distances);

/// Returns the mean of a matrix or vector of distances, over the finite ones if some are infinite; 0 if none is finite.
template <typename Distances>
double mean_distance(const Distances& distances) {
  const double plain = distances.size() > 0 ? distances.mean() : 0;
  if (std::isfinite(plain)) return plain;
  const auto count = static_cast<double>(distances.array().isFinite().count());
  double mean = 0;
  for (const double distance : distances.reshaped()) mean += std::isfinite(distance) ? distance / count : 0;
  return std::min(mean, std::numeric_limits<double>::max());
}

/// Returns the mean of the matrix and its transpose, with a zero diagonal.
DistanceMatrix symmetrise(const DistanceMatrix& distances);

}  // namespace shapegauge

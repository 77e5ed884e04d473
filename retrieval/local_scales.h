#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "shapegauge/retrieval/nearest_models.h"

/// Local scales of distances: a unit of length for each model (Zelnik-Manor and Perona 2004).

namespace shapegauge {

/// Returns the mean distance of a model to its ten nearest, from its distances to all models. Ignores models at
/// distance 0, which are duplicates, infinite distances, and the entry `itself`. NaN if none is left.
double mean_distance_to_nearest(std::span<const double> distances, Eigen::Index itself = -1);

/// Local scales of the models of a collection.
struct LocalScales {
  Eigen::VectorXd roots;  ///< square roots, by model; 1 for a model without positive finite distances
  double least = 0;       ///< lower limit of the scales: a hundredth of the median. 0 if no model has a scale

  /// Computes the scales from mean_distance_to_nearest() of each model.
  static LocalScales of_means(const Eigen::VectorXd& means);

  /// Returns the square root of the scale of a model with that mean distance to its nearest. The model need not belong
  /// to the collection.
  [[nodiscard]] double root_of(double mean) const;
};

/// Estimates the interquartile range of a collection's locally scaled distances from the rows of 64 models, or of all
/// models if there are fewer. The 64 are evenly spaced in the order of mean distances; the result therefore depends on
/// the order of models only if means are equal. Ignores infinite distances. Returns 1 if the range is 0 or there are no
/// distances.
double spread_of_scaled(const Eigen::VectorXd& means, const LocalScales& scales, const RowSource& rows);

}  // namespace shapegauge

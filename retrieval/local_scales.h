// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

/// Local scales of distances: a unit of length for each model (Zelnik-Manor and Perona 2004).

namespace shapegauge {

/// Returns the mean distance of a model to its ten nearest models, from its distances to all models. Ignores models at
/// distance 0, which are duplicates, infinite distances, and the model of index `itself` (-1: none). NaN if no distance
/// is left.
double mean_distance_to_nearest(std::span<const double> distances, Eigen::Index itself = -1);

/// Local scales of the models of a collection: mean distances to the ten nearest models, with a lower limit.
struct LocalScales {
  Eigen::VectorXd roots;  ///< square root of the scale of each model; 1 for a model without positive finite distances
  double least = 0;       ///< lower limit of the scales: a hundredth of the median. 0 if no model has a scale

  /// Computes the scales from `means`, the mean_distance_to_nearest() of each model; NaN for a model without a scale.
  static LocalScales of_means(const Eigen::VectorXd& means);

  /// Returns the square root of a model's scale, given mean_distance_to_nearest() of the model; 1 for NaN. The model
  /// need not belong to the collection.
  [[nodiscard]] double root_of(double mean) const;

  /// Divides the distances from one model to each model of the collection by the square roots of both models' scales.
  /// `root` is the square root of the one model's scale.
  [[nodiscard]] Eigen::RowVectorXd scaled(const Eigen::RowVectorXd& distances, double root) const;
};

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

/// Local scales of distances: each model's own unit of length (Zelnik-Manor and Perona 2004).

namespace shapegauge {

/// The mean distance of a model to its ten nearest, from its distances to all models. Models at distance 0 are doubles
/// and do not count, nor do infinite distances, nor the entry `itself`. NaN where none is left.
double mean_distance_to_nearest(std::span<const double> distances, Eigen::Index itself = -1);

/// The scales of the models of a collection.
struct LocalScales {
  Eigen::VectorXd roots;  ///< square roots, by model; 1 for a model without positive finite distances, which needs none
  double least = 0;       ///< a hundredth of the median: a lesser scale counts as this. 0: no model has a scale

  /// From mean_distance_to_nearest() of each model.
  static LocalScales of_means(const Eigen::VectorXd& means);

  /// The square root of the scale of a model with that mean distance to its nearest, which need not be in the
  /// collection.
  [[nodiscard]] double root_of(double mean) const;
};

}  // namespace shapegauge

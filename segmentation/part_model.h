// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/segmentation/region_features.h"

namespace shapegauge {

/// Cache version of trained_part_model() and of RegionFeatures; increment when results change (docs/manual/cache.md).
inline constexpr int part_model_version = 1;

/// Model of the probability that two adjacent regions belong to one part in a human segmentation: a network of one
/// hidden layer over the features.
struct PartModel {
  RegionFeatures mean = RegionFeatures::Zero();       ///< mean of each feature over the training pairs of regions
  RegionFeatures deviation = RegionFeatures::Ones();  ///< standard deviation of each feature, positive
  /// Weights of the hidden units: one row per unit, one column per feature.
  Eigen::Matrix<double, Eigen::Dynamic, region_features, Eigen::RowMajor> hidden;
  Eigen::VectorXd hidden_bias;  ///< bias of each hidden unit
  Eigen::VectorXd output;       ///< weight of each hidden unit in the output
  double output_bias = 0;       ///< constant term of the network's output, before the logistic function

  /// Computes the probability that two regions with these features belong to one part:
  /// logistic(output . tanh(hidden x + hidden_bias) + output_bias), where x are the standardised features, limited to 4
  /// standard deviations.
  [[nodiscard]] double probability(const RegionFeatures& features) const;
};

/// Returns the model used by part_segmentation(), trained by train_part_model() on generated shapes with known parts
/// (docs/manual/segmentation.md).
const PartModel& trained_part_model();

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "shapegauge/segmentation/region_features.h"

namespace shapegauge {

/// To be raised with every change of the trained model or of the features it is asked with: what a cache holds of
/// earlier versions is then computed anew.
inline constexpr int part_model_version = 1;

/// The probability that points of two neighbouring regions belong to one part, as people see it: a network of one
/// hidden layer over the features.
struct PartModel {
  RegionFeatures mean = RegionFeatures::Zero();       ///< of the features
  RegionFeatures deviation = RegionFeatures::Ones();  ///< standard deviation of the features; greater than 0
  Eigen::Matrix<double, Eigen::Dynamic, region_features, Eigen::RowMajor> hidden;  ///< a row a hidden unit
  Eigen::VectorXd hidden_bias;
  Eigen::VectorXd output;
  double output_bias = 0;

  /// logistic(output . tanh(hidden x + hidden_bias) + output_bias), where x are the features in standard deviations
  /// from their means, at most 4.
  [[nodiscard]] double probability(const RegionFeatures& features) const;
};

/// The model that part_segmentation() uses, trained by train_part_model() on generated shapes, which carry their parts
/// (docs/manual/segmentation.md says how).
const PartModel& trained_part_model();

}  // namespace shapegauge

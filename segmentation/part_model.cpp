// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/part_model.h"

#include <cmath>

namespace shapegauge {

namespace {

constexpr double max_deviations = 4;

#include "part_model_weights.inc"

constexpr Eigen::Index row_size = region_features + 2;  ///< features, bias, output

PartModel unpacked() {
  constexpr auto units = static_cast<Eigen::Index>(hidden_units.size()) / row_size;
  PartModel model;
  model.mean = Eigen::Map<const Eigen::VectorXf>(feature_means.data(), region_features).cast<double>();
  model.deviation = Eigen::Map<const Eigen::VectorXf>(feature_deviations.data(), region_features).cast<double>();
  const Eigen::MatrixXd rows = Eigen::Map<const Eigen::MatrixXf>(hidden_units.data(), row_size, units).cast<double>();
  model.hidden = rows.topRows(region_features).transpose();
  model.hidden_bias = rows.row(region_features).transpose();
  model.output = rows.row(region_features + 1).transpose();
  model.output_bias = output_bias;
  return model;
}

}  // namespace

double PartModel::probability(const RegionFeatures& features) const {
  const RegionFeatures x = ((features - mean).array() / deviation.array()).max(-max_deviations).min(max_deviations);
  const Eigen::VectorXd units = (hidden * x + hidden_bias).array().tanh();
  return 1 / (1 + std::exp(-(output.dot(units) + output_bias)));
}

const PartModel& trained_part_model() {
  static const PartModel model = unpacked();
  return model;
}

}  // namespace shapegauge

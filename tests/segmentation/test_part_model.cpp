// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/segmentation/part_model.h"

namespace shapegauge {
namespace {

TEST(PartModel, IsALogisticFunctionOfItsHiddenUnits) {
  PartModel model;
  model.mean.setConstant(1);
  model.deviation.setConstant(2);
  model.hidden.setZero(2, region_features);
  model.hidden(0, 3) = 0.5;
  model.hidden(1, 7) = -1;
  model.hidden_bias = Eigen::Vector2d(0.1, 0.2);
  model.output = Eigen::Vector2d(2, 3);
  model.output_bias = -0.4;
  RegionFeatures features = RegionFeatures::Constant(1);
  features[3] = 4;    // 1.5 deviations
  features[7] = 100;  // clamped to 4
  const double expected = 2 * std::tanh(0.5 * 1.5 + 0.1) + 3 * std::tanh(-4 + 0.2) - 0.4;
  EXPECT_NEAR(model.probability(features), 1 / (1 + std::exp(-expected)), 1e-15);
  features[7] = -100;
  const double other = 2 * std::tanh(0.5 * 1.5 + 0.1) + 3 * std::tanh(4 + 0.2) - 0.4;
  EXPECT_NEAR(model.probability(features), 1 / (1 + std::exp(-other)), 1e-15);
}

TEST(PartModel, TrainedModelReturnsAProbabilityForAnyFeatures) {
  for (const double value : {0.0, 1e9, -1e9}) {
    const double p = trained_part_model().probability(RegionFeatures::Constant(value));
    EXPECT_TRUE(p >= 0 && p <= 1) << p;
  }
}

TEST(PartModel, ClampsFeaturesAtFourStandardDeviationsFromTheMean) {
  const PartModel& model = trained_part_model();
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(model.probability(model.mean + 10 * sign * model.deviation),
              model.probability(model.mean + 4 * sign * model.deviation));
    EXPECT_NE(model.probability(model.mean + 4 * sign * model.deviation),
              model.probability(model.mean + 3 * sign * model.deviation));
  }
}

}  // namespace
}  // namespace shapegauge

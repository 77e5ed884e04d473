// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/segmentation/patch_features.h"

namespace shapegauge {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ScalarField field(std::vector<double> values, std::vector<double> weights) {
  return {Eigen::Map<Eigen::VectorXd>(values.data(), std::ssize(values)),
          Eigen::Map<Eigen::VectorXd>(weights.data(), std::ssize(weights))};
}

TEST(PatchFeatures, AreFractionsOfPatchWeightBelowQuantilesOfTheField) {
  const std::vector<std::int32_t> patch = {0, 0, 1, 1};
  // In order, 2, 5, 6 and 10 are at 0.5, 1.5, 3.5 and 5.5 sixths of the weight; levels are at 1/8, 3/8, 5/8 and 7/8.
  const std::vector<ScalarField> fields = {field({2, 6, 10, 5}, {1, 3, 1, 1})};
  const Eigen::MatrixXd expected{{0.25, 0.25, 1, 1}, {0, 0.5, 0.5, 0.5}};
  EXPECT_TRUE(patch_features(patch, fields, 4).isApprox(expected, 1e-12)) << patch_features(patch, fields, 4);
}

TEST(PatchFeatures, IgnoreMissingValues) {
  const std::vector<std::int32_t> patch = {0, 0, 1, 2};
  const std::vector<ScalarField> fields = {field({0, nan, 1, nan}, {1, 1, 3, 1})};
  const Eigen::MatrixXd expected{{1, 1}, {0, 1}, {0.25, 1}};  // the last patch has the distribution of the whole
  EXPECT_TRUE(patch_features(patch, fields, 2).isApprox(expected, 1e-12));
}

TEST(PatchFeatures, DoNotChangeIfTheLargestValueBecomesAnOutlier) {
  const std::vector<std::int32_t> patch = {0, 0, 0, 1, 1, 1};
  const std::vector<double> weights = {1, 2, 1, 3, 1, 1};
  const std::vector<ScalarField> fields = {field({1, 2, 3, 2, 4, 5}, weights)};
  const std::vector<ScalarField> others = {field({1, 2, 3, 2, 4, 1e9}, weights)};  // one outlier
  const Eigen::MatrixXd features = patch_features(patch, fields, 16);
  EXPECT_EQ(features, patch_features(patch, others, 16));
  EXPECT_FALSE(features.row(0).isApprox(features.row(1)));
}

TEST(PatchFeatures, ConcatenateTheFeaturesOfSeveralFields) {
  const std::vector<std::int32_t> patch = {0, 1};
  const std::vector<ScalarField> fields = {field({0, 1}, {1, 1}), field({5, 5}, {1, 1})};
  const Eigen::MatrixXd expected{{1, 1}, {0, 1}};
  EXPECT_TRUE(patch_features(patch, fields, 1).isApprox(expected, 1e-12));
}

TEST(PatchFeatures, RejectMissingFieldsAndFieldsOfAnotherSize) {
  const std::vector<std::int32_t> patch = {0, 1};
  EXPECT_THROW(patch_features(patch, {}, 4), ArgumentError);
  EXPECT_THROW(patch_features(patch, std::vector{field({0}, {1})}, 4), ArgumentError);
  EXPECT_THROW(patch_features(patch, std::vector{field({0, 1}, {1, 1})}, 0), InputError);
}

}  // namespace
}  // namespace shapegauge

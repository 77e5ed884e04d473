// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/retrieval/feature_checks.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;

DistanceMatrix features_with_offset(double offset) {
  return DistanceMatrix{{0, 1.25, 3}, {1, 4.5, 2}, {5, 9.75, 6}, {2, 3, 3.5}}.array() + offset;
}

TEST(CheckFeatures, AcceptsSmallNumbersWithoutAWarning) {
  EXPECT_FALSE(check_features(features_with_offset(0)));
  EXPECT_FALSE(check_features(features_with_offset(0.1)));
}

// At 1e7 + 0.1 the spacing of single precision is 1.
TEST(CheckFeatures, WarnsOfDifferencesLostInSinglePrecision) {
  EXPECT_THAT(check_features(features_with_offset(1e7 + 0.1)).value(), HasSubstr("% of the spread"));
  EXPECT_THAT(check_features(features_with_offset(1e9)).value(), HasSubstr("equal others"));
}

TEST(CheckFeatures, RefusesNumbersBeyondSinglePrecision) {
  EXPECT_THROW(check_features(features_with_offset(1e39)), InputError);
}

TEST(CheckFeatures, RefusesAColumnOfRowNumbers) {
  DistanceMatrix features = DistanceMatrix::Random(12, 3);
  EXPECT_FALSE(check_features(features));
  for (const double first : {0.0, 1.0, 2.0}) {
    for (Eigen::Index row = 0; row < 12; ++row) features(row, 1) = first + static_cast<double>(row);
    if (first == 2) {
      EXPECT_FALSE(check_features(features));
    } else {
      EXPECT_THAT(
          [&] { check_features(features); },
          testing::ThrowsMessage<InputError>(HasSubstr("column 1 (counted from 0) has the numbers of the rows")));
    }
  }
}

TEST(CheckFeatures, RefusesAMatrixOfDistances) {
  DistanceMatrix distances{{0, 1, 2}, {1, 0, 3}, {2, 3, 0}};
  EXPECT_THROW(check_features(distances), InputError);
  distances(0, 2) = 2.5;
  EXPECT_FALSE(check_features(distances));
  EXPECT_FALSE(check_features(DistanceMatrix{{0, 1}, {1, 0}})) << "two models of two features";
}

}  // namespace

}  // namespace shapegauge

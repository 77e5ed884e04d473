#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "shapegauge/experiments/comparison/value_errors.h"

namespace shapegauge {
namespace {

/// Ten places on a line with the values 1 to 10.
PlacedValues line() {
  PlacedValues placed{.points = Points::Zero(10, 3), .values = Eigen::VectorXd::LinSpaced(10, 1, 10)};
  placed.points.col(0) = Eigen::VectorXd::LinSpaced(10, 0, 9);
  return placed;
}

TEST(ValueErrors, AreNoneForTheReferenceItself) {
  const ValueErrors errors = value_errors(line(), line(), 9);
  EXPECT_EQ(errors.median, 0);
  EXPECT_EQ(errors.percentile_90, 0);
  EXPECT_EQ(errors.relative_median, 0);
  EXPECT_EQ(errors.relative_percentile_90, 0);
}

TEST(ValueErrors, AreThoseFromTheNearestSample) {
  PlacedValues moved = line();
  moved.points.col(0).array() += 0.3;
  moved.points.col(1).array() += 7;
  moved.values *= 1.5;  // errors of 0.5, 1, ... 5
  const ValueErrors errors = value_errors(moved, line(), 10);
  EXPECT_DOUBLE_EQ(errors.median, 0.25);
  EXPECT_DOUBLE_EQ(errors.percentile_90, 0.45);
  EXPECT_DOUBLE_EQ(errors.relative_median, 0.5);
  EXPECT_DOUBLE_EQ(errors.relative_percentile_90, 0.5);
}

TEST(ValueErrors, OfAValueOfZeroAreInfiniteOrNone) {
  PlacedValues reference = line();
  reference.values.setZero();
  EXPECT_EQ(value_errors(reference, reference, 9).relative_median, 0);
  EXPECT_EQ(value_errors(line(), reference, 9).relative_median, std::numeric_limits<double>::infinity());
}

TEST(PlacedValues, AreThoseThatAreThereInTheirOwnUnits) {
  Samples samples;
  samples.points = line().points;
  samples.weights = Eigen::VectorXd::Ones(10);
  samples.weights[2] = 0;
  Eigen::VectorXd values = line().values;
  values[4] = std::nan("");
  const PlacedValues placed = placed_values(samples, values, 2);
  ASSERT_EQ(placed.values.size(), 8);
  EXPECT_EQ(placed.values[2], 8);
  EXPECT_EQ(placed.points(2, 0), 6);
}

}  // namespace
}  // namespace shapegauge

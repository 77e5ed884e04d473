// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/experiments/shape_comparison/field_errors.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

TEST(WeightedQuantile, IsTheSmallestValueWhoseCumulativeWeightReachesTheFraction) {
  const Eigen::VectorXd values = Eigen::Vector4d(7, 1, 5, 3);
  const Eigen::VectorXd once = Eigen::VectorXd::Ones(4);
  EXPECT_EQ(weighted_quantile(values, once, 0.5), 3);
  EXPECT_EQ(weighted_quantile(values, once, 0.51), 5);
  EXPECT_EQ(weighted_quantile(values, once, 1), 7);
  EXPECT_EQ(weighted_quantile(values, Eigen::Vector4d(10, 1, 1, 1), 0.5), 7);
  EXPECT_EQ(weighted_quantile(values, Eigen::Vector4d(1, 0, 1, 0), 0), 5) << "what has no weight is no answer";
}

TEST(WeightedQuantile, IsNaNWithoutValues) {
  EXPECT_TRUE(std::isnan(weighted_quantile({}, {}, 0.5)));
  EXPECT_TRUE(std::isnan(weighted_quantile(Eigen::Vector2d(1, 2), Eigen::Vector2d(0, 0), 0.5)));
  EXPECT_THROW(weighted_quantile(Eigen::Vector2d(1, 2), Eigen::VectorXd::Ones(3), 0.5), ArgumentError);
}

constexpr double rounding = 1e-5;  // degrees; the cross product of unit vectors is accurate to 1e-15

TEST(NormalErrors, AreZeroForTheNormalsOfTheTriangles) {
  const Shape box = test::box({3, 2, 1}, 4);
  const Samples samples = sample_shape(box, SampleSite::faces);
  const NormalErrors errors = normal_errors(TrueNormals(box), samples.points, samples.normals, samples.weights, true);
  EXPECT_LT(errors.mean, rounding);
  EXPECT_LT(errors.percentile_90, rounding);
}

TEST(NormalErrors, AreTheAnglesToTheTrueNormals) {
  const Shape box = test::box({3, 2, 1}, 4);
  const Samples samples = sample_shape(box, SampleSite::faces);
  Points turned = samples.normals;
  for (Eigen::Index i = 0; i < turned.rows(); ++i) {
    const Eigen::Vector3d normal = samples.normals.row(i);
    turned.row(i) = Eigen::AngleAxisd(0.1, normal.unitOrthogonal()) * normal;
  }
  const NormalErrors errors = normal_errors(TrueNormals(box), samples.points, turned, samples.weights, true);
  EXPECT_NEAR(errors.mean, 5.729578, rounding);
  EXPECT_NEAR(errors.median, 5.729578, rounding);
}

TEST(NormalErrors, OfReversedNormalsAre180DegreesOnlyIfOrientationCounts) {
  const Shape box = test::box({3, 2, 1}, 4);
  const Samples samples = sample_shape(box, SampleSite::faces);
  const TrueNormals truth(box);
  const Points turned = -samples.normals;
  EXPECT_NEAR(normal_errors(truth, samples.points, turned, samples.weights, true).median, 180, rounding);
  EXPECT_LT(normal_errors(truth, samples.points, turned, samples.weights, false).median, rounding);
}

TEST(NormalErrors, IgnoreMissingNormalsAndZeroWeights) {
  const Shape box = test::box({3, 2, 1}, 4);
  Samples samples = sample_shape(box, SampleSite::faces);
  samples.normals.row(0).setZero();
  samples.normals.row(1) *= -1;
  samples.weights[1] = 0;
  const TrueNormals truth(box);
  EXPECT_LT(normal_errors(truth, samples.points, samples.normals, samples.weights, true).mean, rounding);
  samples.normals.setZero();
  EXPECT_TRUE(std::isnan(normal_errors(truth, samples.points, samples.normals, samples.weights, true).mean));
}

TEST(TrueNormals, AreRejectedForAPointCloud) {
  EXPECT_THROW(TrueNormals({test::sphere(1, 1).vertices, {}, {}}), ArgumentError);
}

/// Ten points on a line with the values 1 to 10.
LocatedValues line() {
  LocatedValues result{.points = Points::Zero(10, 3), .values = Eigen::VectorXd::LinSpaced(10, 1, 10)};
  result.points.col(0) = Eigen::VectorXd::LinSpaced(10, 0, 9);
  return result;
}

TEST(ValueErrors, AreZeroForTheReferenceItself) {
  const ValueErrors errors = value_errors(line(), line(), 9);
  EXPECT_EQ(errors.median, 0);
  EXPECT_EQ(errors.percentile_90, 0);
  EXPECT_EQ(errors.relative_median, 0);
  EXPECT_EQ(errors.relative_percentile_90, 0);
}

TEST(ValueErrors, CompareWithTheNearestReferenceSample) {
  LocatedValues moved = line();
  moved.points.col(0).array() += 0.3;
  moved.points.col(1).array() += 7;
  moved.values *= 1.5;  // errors of 0.5, 1, ... 5
  const ValueErrors errors = value_errors(moved, line(), 10);
  EXPECT_DOUBLE_EQ(errors.median, 0.25);
  EXPECT_DOUBLE_EQ(errors.percentile_90, 0.45);
  EXPECT_DOUBLE_EQ(errors.relative_median, 0.5);
  EXPECT_DOUBLE_EQ(errors.relative_percentile_90, 0.5);
}

TEST(ValueErrors, AreFractionsOfTheDiagonalToThePowerOfTheDimension) {
  const auto median = [](FieldDimension dimension) {
    LocatedValues reference = line();
    reference.dimension = dimension;
    LocatedValues moved = reference;
    moved.values.array() += 2;
    return value_errors(moved, reference, 10).median;
  };
  EXPECT_DOUBLE_EQ(median(FieldDimension::none), 2);
  EXPECT_DOUBLE_EQ(median(FieldDimension::length), 0.2);
  EXPECT_DOUBLE_EQ(median(FieldDimension::area), 0.02);
}

TEST(ValueErrors, RelativeToNegativeValuesArePositive) {
  LocatedValues reference = line();
  reference.values *= -1;
  LocatedValues moved = reference;
  moved.values *= 1.5;
  EXPECT_DOUBLE_EQ(value_errors(moved, reference, 9).relative_median, 0.5);
}

TEST(ValueErrors, RelativeToZeroAreInfiniteOrZero) {
  LocatedValues reference = line();
  reference.values.setZero();
  EXPECT_EQ(value_errors(reference, reference, 9).relative_median, 0);
  EXPECT_EQ(value_errors(line(), reference, 9).relative_median, std::numeric_limits<double>::infinity());
}

TEST(LocatedValues, ExcludeMissingValuesAndUseTheUnitsOfTheFile) {
  Samples samples;
  samples.points = line().points;
  samples.weights = Eigen::VectorXd::Ones(10);
  samples.weights[2] = 0;
  Eigen::VectorXd values = line().values;
  values[4] = std::nan("");
  const LocatedValues result = located_values(samples, values, FieldDimension::length, 2);
  ASSERT_EQ(result.values.size(), 8);
  EXPECT_EQ(result.values[2], 8);
  EXPECT_EQ(result.points(2, 0), 6);
}

TEST(LocatedValues, LengthsAndAreasAreScaledToTheUnitsOfTheFile) {
  Samples samples;
  samples.points = line().points;
  samples.weights = Eigen::VectorXd::Ones(10);
  const auto values = [&](FieldDimension dimension) {
    const LocatedValues result = located_values(samples, line().values, dimension, 3);
    EXPECT_EQ(result.points(2, 0), 6) << "positions are lengths whatever the values are";
    EXPECT_EQ(result.dimension, dimension);
    return result.values;
  };
  EXPECT_EQ(values(FieldDimension::none), line().values);
  EXPECT_EQ(values(FieldDimension::length), 3 * line().values);
  EXPECT_EQ(values(FieldDimension::area), 9 * line().values);
}

}  // namespace

}  // namespace shapegauge

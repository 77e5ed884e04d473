#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/experiments/comparison/normal_errors.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

constexpr double rounding = 1e-5;  // degrees; the cross product of unit vectors is good to 1e-15

TEST(NormalErrors, AreNoneForTheTrianglesOwnNormals) {
  const Shape box = test_shapes::box({3, 2, 1}, 4);
  const Samples samples = sample_shape(box, SampleSite::faces);
  const NormalErrors errors = normal_errors(TrueNormals(box), samples.points, samples.normals, samples.weights, true);
  EXPECT_LT(errors.mean, rounding);
  EXPECT_LT(errors.percentile_90, rounding);
}

TEST(NormalErrors, AreTheAngleByWhichNormalsAreTurned) {
  const Shape box = test_shapes::box({3, 2, 1}, 4);
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

TEST(NormalErrors, ANormalThatPointsTheOtherWayIsWrongIfSidesMatter) {
  const Shape box = test_shapes::box({3, 2, 1}, 4);
  const Samples samples = sample_shape(box, SampleSite::faces);
  const TrueNormals truth(box);
  const Points turned = -samples.normals;
  EXPECT_NEAR(normal_errors(truth, samples.points, turned, samples.weights, true).median, 180, rounding);
  EXPECT_LT(normal_errors(truth, samples.points, turned, samples.weights, false).median, rounding);
}

TEST(NormalErrors, WhatIsNotThereDoesNotCount) {
  const Shape box = test_shapes::box({3, 2, 1}, 4);
  Samples samples = sample_shape(box, SampleSite::faces);
  samples.normals.row(0).setZero();
  samples.normals.row(1) *= -1;
  samples.weights[1] = 0;
  const TrueNormals truth(box);
  EXPECT_LT(normal_errors(truth, samples.points, samples.normals, samples.weights, true).mean, rounding);
  samples.normals.setZero();
  EXPECT_TRUE(std::isnan(normal_errors(truth, samples.points, samples.normals, samples.weights, true).mean));
}

TEST(TrueNormals, ACloudHasNone) {
  EXPECT_THROW(TrueNormals({test_shapes::sphere(1, 1).vertices, {}, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/fields/bilateral.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

struct Site {
  const char* name;
  Shape shape;
  Samples samples;
};

std::vector<Site> sites() {
  const Shape mesh = test::sphere(1, 4);
  const Shape cloud = {mesh.vertices, {}};
  return {{"faces", mesh, sample_shape(mesh, SampleSite::faces)},
          {"vertices", mesh, sample_shape(mesh, SampleSite::vertices)},
          {"surface", mesh, sample_surface(mesh, 3000)},
          {"soup", test::soup(mesh), sample_shape(test::soup(mesh), SampleSite::vertices)},
          {"cloud", cloud, sample_shape(cloud, SampleSite::vertices)}};
}

/// 1 above the equator and 0 below it, plus noise.
ScalarField noisy_step(const Samples& samples, double noise) {
  RandomNumbers random(1);
  ScalarField field{Eigen::VectorXd(samples.points.rows()), samples.weights};
  for (Eigen::Index i = 0; i < field.values.size(); ++i) {
    field.values[i] = (samples.points(i, 2) > 0 ? 1 : 0) + random.uniform(-noise, noise);
  }
  return field;
}

TEST(BilateralSmoothing, KeepsStepsAndRemovesNoise) {
  for (const Site& site : sites()) {
    const ScalarField field = noisy_step(site.samples, 0.1);
    const ScalarField smooth =
        bilateral_smoothing(site.shape, site.samples, field, {.iterations = 3, .spatial_width = 0.05});
    const Eigen::VectorXd step = noisy_step(site.samples, 0).values;
    const double before = (field.values - step).norm();
    const double after = (smooth.values - step).norm();
    EXPECT_LT(after, 0.4 * before) << site.name;
    // Also next to the step.
    EXPECT_LT((smooth.values - step).cwiseAbs().maxCoeff(), 0.2) << site.name;
  }
}

TEST(BilateralSmoothing, BlursStepsForLargeValueWidths) {
  const Site site = sites()[1];
  const ScalarField step = noisy_step(site.samples, 0);
  const BilateralOptions options = {.iterations = 3, .spatial_width = 0.05, .value_width = 100};
  const ScalarField blurred = bilateral_smoothing(site.shape, site.samples, step, options);
  EXPECT_GT((blurred.values - step.values).cwiseAbs().maxCoeff(), 0.25);
}

TEST(BilateralSmoothing, StaysWithinTheRangeOfTheValues) {
  const Site site = sites()[0];
  const ScalarField field = noisy_step(site.samples, 1);
  const ScalarField smooth = bilateral_smoothing(site.shape, site.samples, field, {.iterations = 2});
  EXPECT_GE(smooth.values.minCoeff(), field.values.minCoeff());
  EXPECT_LE(smooth.values.maxCoeff(), field.values.maxCoeff());
  EXPECT_EQ(smooth.weights, field.weights);
}

TEST(BilateralSmoothing, LeavesValuesUnchangedWithoutIterationsAndOnConstantFields) {
  const Site site = sites()[0];
  const ScalarField field = noisy_step(site.samples, 1);
  EXPECT_EQ(bilateral_smoothing(site.shape, site.samples, field, {.iterations = 0}).values, field.values);
  const ScalarField flat{Eigen::VectorXd::Constant(field.values.size(), 3), field.weights};
  EXPECT_TRUE(bilateral_smoothing(site.shape, site.samples, flat).values.isApprox(flat.values, 1e-14));
}

TEST(BilateralSmoothing, KeepsMissingValuesAndDoesNotSpreadThem) {
  const Site site = sites()[0];
  ScalarField field = noisy_step(site.samples, 0.1);
  field.values[10] = std::numeric_limits<double>::quiet_NaN();
  const ScalarField smooth = bilateral_smoothing(site.shape, site.samples, field);
  EXPECT_TRUE(std::isnan(smooth.values[10]));
  EXPECT_EQ(smooth.values.array().isNaN().count(), 1);
}

TEST(BilateralSmoothing, RefusesOptionsOutOfRangeAndFieldsOfOtherSamples) {
  const Site site = sites()[0];
  const ScalarField field = noisy_step(site.samples, 0.1);
  for (const BilateralOptions& options :
       {BilateralOptions{.iterations = -1}, BilateralOptions{.spatial_width = 0}, BilateralOptions{.value_width = 0}}) {
    EXPECT_THROW(bilateral_smoothing(site.shape, site.samples, field, options), InputError);
  }
  EXPECT_THROW(bilateral_smoothing(site.shape, sites()[1].samples, field), InputError);
  EXPECT_THROW(bilateral_smoothing(test::sphere(1, 2), site.samples, field), InputError);
}

TEST(BilateralSmoothing, IsTheWeightedMeanOfValuesWithinTwoSpatialWidths) {
  const Shape one{Points{{0, 0, 0}, {1, 0, 0}, {0, 5, 0}}, Triangles{{0, 1, 2}}};
  const ScalarField field{Eigen::Vector3d(0, 1, 5), Eigen::Vector3d(1, 2, 1)};  // the width is 0.4 sqrt(4) = 0.8
  const double near = 2 * std::exp(-0.5 / (0.8 * 0.8));
  const ScalarField smoothed = bilateral_smoothing(one, sample_shape(one, SampleSite::vertices), field,
                                                   {.iterations = 1, .spatial_width = 0.4, .value_width = 1e6});
  EXPECT_NEAR(smoothed.values[0], near / (1 + near), 1e-9);
}

}  // namespace
}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/math/special_functions/spherical_harmonic.hpp>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/retrieval/descriptors/spherical_harmonics.h"
#include "shapegauge/retrieval/distances.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// A real harmonic at the directions.
Eigen::VectorXd harmonic(const Points& directions, int l, int m) {
  Eigen::VectorXd values(directions.rows());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double polar = std::acos(std::clamp(directions(i, 2), -1.0, 1.0));
    const double azimuth = std::atan2(directions(i, 1), directions(i, 0));
    values[i] = boost::math::spherical_harmonic_r(l, m, polar, azimuth);
  }
  return values;
}

TEST(SphericalHarmonicNorms, OfASingleHarmonicAreZeroAtOtherFrequencies) {
  const int bandwidth = 8;
  const HarmonicTransform transform(bandwidth);
  for (int l = 0; l < bandwidth; ++l) {
    for (int m = 0; m <= l; ++m) {
      const Eigen::VectorXd norms = transform.norms(harmonic(transform.directions(), l, m));
      // The real part of a non-zonal harmonic has half of its power.
      const double expected = m == 0 ? 1 : std::sqrt(0.5);
      for (int k = 0; k < bandwidth; ++k) EXPECT_NEAR(norms[k], k == l ? expected : 0, 1e-10) << l << " " << m;
    }
  }
}

TEST(SphericalHarmonicNorms, DoNotChangeIfTheFunctionIsRotated) {
  const HarmonicTransform transform(8);
  const Points& directions = transform.directions();
  const auto function = [](const Points& at) {
    return Eigen::VectorXd(harmonic(at, 3, 2) + 2 * harmonic(at, 5, 1) - harmonic(at, 6, 6));
  };
  const Eigen::VectorXd expected = transform.norms(function(directions));
  const Points turned = directions * test::rotation(3).transpose();
  EXPECT_LT((transform.norms(function(turned)) - expected).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(SphericalHarmonicNorms, RejectAWrongNumberOfValues) {
  EXPECT_THROW(static_cast<void>(HarmonicTransform(4).norms(Eigen::VectorXd::Zero(7))), ArgumentError);
}

double distance_of_harmonics(const Eigen::VectorXf& a, const Eigen::VectorXf& b) {
  return l2_distance({a.data(), static_cast<std::size_t>(a.size())}, {b.data(), static_cast<std::size_t>(b.size())});
}

TEST(SphericalHarmonics, OfASphereAreZeroExceptAtFrequencyZero) {
  const SphericalHarmonicsOptions options = {.shells = 16, .bandwidth = 8, .width = 0.25};
  const Eigen::VectorXf found = spherical_harmonics(test::sphere(5, 4), options);
  for (Eigen::Index shell = 0; shell < options.shells; ++shell) {
    const double radius = static_cast<double>(shell + 1) / 8;
    const double away = (radius - 1) / options.width;
    const double value = std::abs(away) < 4 ? std::exp(-away * away) : 0;
    const double expected = radius * std::sqrt(4 * std::numbers::pi) * value;
    EXPECT_NEAR(found[shell * options.bandwidth], expected, 0.02) << shell;
    for (Eigen::Index l = 1; l < options.bandwidth; ++l) EXPECT_LT(found[shell * options.bandwidth + l], 0.02);
  }
}

TEST(SphericalHarmonics, HardlyChangeUnderRotationTranslationAndScale) {
  const Shape bar = test::box({1, 2, 4}, 3);
  const Shape other = test::box({1, 3, 3}, 3);
  for (const bool voxels : {false, true}) {
    const SphericalHarmonicsOptions options = {.voxels = voxels};
    const Eigen::VectorXf expected = spherical_harmonics(bar, options);
    const double to_other = distance_of_harmonics(spherical_harmonics(other, options), expected);
    const Shape moved = test::transformed(bar, 3, Eigen::Matrix3d::Identity(), {5, 6, 7});
    EXPECT_LT(distance_of_harmonics(spherical_harmonics(moved, options), expected), 0.02 * to_other) << voxels;
    for (const unsigned seed : {1U, 2U, 3U}) {
      const Shape turned = test::transformed(bar, 1, test::rotation(seed), {0, 0, 0});
      // The voxel grid does not rotate with the shape.
      const double tolerance = voxels ? 0.75 : 0.1;
      EXPECT_LT(distance_of_harmonics(spherical_harmonics(turned, options), expected), tolerance * to_other) << voxels;
    }
  }
}

TEST(SphericalHarmonics, HardlyDependOnFaceOrientationAndMeshing) {
  const Shape bar = test::box({1, 2, 4}, 3);
  const Eigen::VectorXf expected = spherical_harmonics(bar);
  // Centroid and size are estimated from other samples.
  const double tolerance = 0.02 * expected.norm();
  EXPECT_LT(distance_of_harmonics(spherical_harmonics(test::flipped(test::soup(bar))), expected), tolerance);
  EXPECT_LT(distance_of_harmonics(spherical_harmonics(test::box({1, 2, 4}, 7)), expected), tolerance);
}

TEST(SphericalHarmonics, OfAPointCloudAreCloseToThoseOfItsMesh) {
  const Shape ball = test::sphere(1, 4);
  const Eigen::VectorXf mesh = spherical_harmonics(ball);
  EXPECT_LT(distance_of_harmonics(spherical_harmonics(Shape{ball.vertices, {}}), mesh), 0.1 * mesh.norm());
}

TEST(SphericalHarmonics, RefuseOptionsOutOfRangeAndShapesWithoutExtent) {
  const Shape ball = test::sphere(1, 1);
  EXPECT_THROW(spherical_harmonics(ball, {.shells = 0}), InputError);
  EXPECT_THROW(spherical_harmonics(ball, {.bandwidth = 65}), InputError);
  EXPECT_THROW(spherical_harmonics(ball, {.width = 0}), InputError);
  EXPECT_THROW(spherical_harmonics(Shape{Points::Zero(4, 3), {}}), InputError);
}

}  // namespace
}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/retrieval/descriptors/cylinder_map.h"
#include "shapegauge/retrieval/descriptors/panorama.h"
#include "shapegauge/retrieval/descriptors/surface_moments.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Of a pose: by axis, map, subband and statistic.
constexpr Eigen::Index wavelet_features = 3 * 2 * 19 * 3;

double distance_of_panoramas(const Eigen::VectorXf& a, const Eigen::VectorXf& b) {
  return panorama_distance({a.data(), static_cast<std::size_t>(a.size())},
                           {b.data(), static_cast<std::size_t>(b.size())});
}

/// A bar with a knob: distinct principal axes, and no symmetry.
Shape knobbed_bar() {
  const auto at = [](const Shape& part, const Eigen::Vector3d& position) {
    return test::transformed(part, 1, Eigen::Matrix3d::Identity(), position);
  };
  return test::joined({test::box({1, 2, 4}, 4), at(test::sphere(0.5, 3), {0.6, 1, 1.5})});
}

/// Distance from the knobbed bar to the nearest of several other shapes.
double distance_to_others() {
  const Eigen::VectorXf bar = panorama(knobbed_bar());
  double nearest = std::numeric_limits<double>::infinity();
  for (const Shape& other : {test::box({1, 1, 1}, 2), test::sphere(1, 3), test::torus(1, 0.3, 24, 12)}) {
    nearest = std::min(nearest, distance_of_panoramas(panorama(other), bar));
  }
  return nearest;
}

TEST(PanoramaDescriptor, FourierFeaturesMatchADirectFourierTransform) {
  const PanoramaOptions options = {.frequencies = 3};
  // A box along x is its own principal pose, except for signs.
  const Shape box = test::box({4, 2, 1}, 2);
  const Eigen::VectorXf found = panorama(box, options);
  const double spread = std::sqrt(surface_moments(box).covariance.trace());
  const CylinderGrid map =
      project_on_cylinder(box, {.axis = 0, .radius = options.radius * spread}).cosine.array().pow(options.sharpness);
  const auto magnitude = [&](int along, int around) {
    std::complex<double> sum = 0;
    for (Eigen::Index row = 0; row < map.rows(); ++row) {
      for (Eigen::Index column = 0; column < map.cols(); ++column) {
        const double turns = static_cast<double>(along * row) / static_cast<double>(map.rows()) +
                             static_cast<double>(around * column) / static_cast<double>(map.cols());
        sum += static_cast<double>(map(row, column)) * std::polar(1.0, -2 * std::numbers::pi * turns);
      }
    }
    return std::abs(sum);
  };
  double total = 0;
  for (int around = 0; around <= 3; ++around) {
    for (int along = 0; along <= 3; ++along) total += magnitude(along, around) + magnitude(-along, around);
  }
  Eigen::Index next = 2 * 16;  // the first cylinder's map of distances has 2 x 4 x 4 features
  for (const bool greater : {true, false}) {
    for (int around = 0; around <= 3; ++around) {
      for (int along = 0; along <= 3; ++along, ++next) {
        const double one = magnitude(along, around);
        const double other = magnitude(-along, around);
        const double expected = greater ? std::max(one, other) : std::min(one, other);
        EXPECT_NEAR(found[next], std::pow(expected / total, options.exponent), 2e-4) << along << " " << around;
      }
    }
  }
  EXPECT_EQ(found.size(), 2 * (3 * 2 * 2 * 16 + wavelet_features));
}

TEST(PanoramaDescriptor, HardlyChangesUnderRotationReflectionTranslationAndScale) {
  const Shape bar = knobbed_bar();
  const Eigen::VectorXf expected = panorama(bar);
  const double tolerance = 0.02 * distance_to_others();
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Shape turned = test::transformed(bar, 3, test::rotation(seed), {5, 6, 7});
    EXPECT_LT(distance_of_panoramas(panorama(turned), expected), tolerance) << seed;
  }
  for (int axis = 0; axis < 3; ++axis) {
    Shape mirrored = bar;
    mirrored.vertices.col(axis) *= -1;
    EXPECT_LT(distance_of_panoramas(panorama(mirrored), expected), tolerance) << axis;
  }
}

TEST(PanoramaDescriptor, HardlyDependsOnFaceOrderFaceOrientationOrMeshing) {
  const Shape bar = test::box({1, 2, 4}, 2);
  const Eigen::VectorXf expected = panorama(bar);
  const double tolerance = 0.01 * distance_of_panoramas(panorama(test::box({1, 1, 4}, 2)), expected);
  for (const Shape& same :
       {test::flipped(bar), test::soup(bar), test::permuted(bar, 3).shape, test::box({1, 2, 4}, 7)}) {
    EXPECT_LT(distance_of_panoramas(panorama(same), expected), tolerance);
  }
}

TEST(PanoramaDescriptor, CloudIsCloseToItsMesh) {
  const Shape bar = knobbed_bar();
  const Eigen::VectorXf cloud = panorama(test::random_points(bar, 10'000, 1));
  EXPECT_LT(distance_of_panoramas(cloud, panorama(bar)), 0.4 * distance_to_others());
}

/// Features of two Fourier magnitudes in each pose, the wavelet features all the same.
Eigen::VectorXf features_of(const Eigen::Vector4f& fourier, float wavelets) {
  Eigen::VectorXf features = Eigen::VectorXf::Constant(4 + 2 * wavelet_features, wavelets);
  features.head<2>() = fourier.head<2>();
  features.segment<2>(2 + wavelet_features) = fourier.tail<2>();
  return features;
}

TEST(PanoramaDescriptor, DistanceIsTheMinimumOverTheTwoPoses) {
  const Eigen::VectorXf a = features_of({1, 2, 3, 4}, 1);
  const Eigen::VectorXf b = features_of({2, 4, 3, 2}, 1);
  EXPECT_EQ(distance_of_panoramas(a, b), 2);
  EXPECT_EQ(distance_of_panoramas(b, a), 2);
  EXPECT_THROW(distance_of_panoramas(a, features_of({1, 2, 3, 4}, 1).tail(4 + wavelet_features)), ArgumentError);
  EXPECT_THROW(distance_of_panoramas(Eigen::Vector2f(1, 2), Eigen::Vector2f(1, 2)), ArgumentError);
}

TEST(PanoramaDescriptor, WaveletFeaturesAreComparedByRelativeDifference) {
  const Eigen::Vector4f same(1, 2, 3, 4);
  EXPECT_NEAR(distance_of_panoramas(features_of(same, 1), features_of(same, 3)), 20 * 0.5, 1e-9);
  EXPECT_EQ(distance_of_panoramas(features_of(same, 0), features_of(same, 0)), 0);
}

/// The orthonormal Haar matrix of so many entries: details from the finest level on, the mean at last.
Eigen::MatrixXd haar_matrix(Eigen::Index size) {
  if (size == 1) return Eigen::MatrixXd::Ones(1, 1);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(size / 2, size);
  Eigen::MatrixXd differences = sums;
  for (Eigen::Index i = 0; i < size / 2; ++i) {
    sums(i, 2 * i) = sums(i, 2 * i + 1) = differences(i, 2 * i) = std::sqrt(0.5);
    differences(i, 2 * i + 1) = -std::sqrt(0.5);
  }
  Eigen::MatrixXd all(size, size);
  all << differences, haar_matrix(size / 2) * sums;
  return all;
}

TEST(PanoramaDescriptor, WaveletFeaturesMatchTheHaarTransform) {
  const PanoramaOptions options;
  const Shape box = test::box({4, 2, 1}, 2);  // along x is its own principal pose, except for signs
  const Eigen::VectorXf found = panorama(box, options);
  const double spread = std::sqrt(surface_moments(box).covariance.trace());
  const CylinderGrid map = project_on_cylinder(box, {.axis = 0, .radius = options.radius * spread}).distance;
  // Around the axis a first step brings 128 columns to 64; the approximation of 64 x 64 is transformed at once.
  const Eigen::MatrixXd around = haar_matrix(128);
  const Eigen::MatrixXd along = haar_matrix(64);
  const Eigen::MatrixXd both = along * map.cast<double>() * around.transpose();
  const Eigen::Index first = 3 * 2 * 2 * 13 * 13;
  // Details in both directions of each level are the same in the whole transform and level by level.
  Eigen::Index row = 0;
  Eigen::Index column = 0;
  for (Eigen::Index level = 0; level < 6; ++level) {
    const Eigen::ArrayXXd block = both.block(row, column, 32 >> level, 64 >> level).cwiseAbs();
    const double mean = block.mean();
    const double deviation = std::sqrt((block - mean).square().mean());
    EXPECT_NEAR(found[first + (3 * level + 2) * 3], mean, 1e-4) << level;
    EXPECT_NEAR(found[first + (3 * level + 2) * 3 + 1], deviation, 1e-4) << level;
    if (deviation > 1e-3) {
      EXPECT_NEAR(found[first + (3 * level + 2) * 3 + 2], (block - mean).cube().mean() / std::pow(deviation, 3), 0.01);
    }
    row += 32 >> level;
    column += 64 >> level;
  }
}

TEST(PanoramaDescriptor, RefusesOptionsOutOfRangeAndShapesWithoutArea) {
  const Shape ball = test::sphere(1, 1);
  EXPECT_THROW(panorama(ball, {.angles = 8}), InputError);
  EXPECT_THROW(panorama(ball, {.heights = 2000}), InputError);
  EXPECT_THROW(panorama(ball, {.heights = 100}), InputError);
  EXPECT_THROW(panorama(ball, {.frequencies = 0}), InputError);
  EXPECT_THROW(panorama(ball, {.exponent = 0}), InputError);
  EXPECT_THROW(panorama(ball, {.sharpness = 17}), InputError);
  EXPECT_THROW(panorama(ball, {.radius = std::nan("")}), InputError);
  EXPECT_THROW(panorama(Shape{}), InputError);
  EXPECT_THROW(panorama(Shape{Points::Zero(4, 3), {}}), InputError);
  Shape broken = ball;
  broken.vertices(0, 0) = std::nan("");
  EXPECT_THROW(panorama(broken), InputError);
  Shape line = ball;
  line.vertices.rightCols<2>().setZero();
  EXPECT_THROW(panorama(line), InputError);
}

TEST(PanoramaDescriptor, DistinguishesFlatShapes) {
  const auto sheet = [](double width) {
    return Shape{Points{{0, 0, 0}, {2, 0, 0}, {2, width, 0}, {0, width, 0}}, Triangles{{0, 1, 2}, {0, 2, 3}}};
  };
  const Eigen::VectorXf expected = panorama(sheet(1));
  EXPECT_TRUE(expected.allFinite());
  const double to_another = distance_of_panoramas(panorama(sheet(0.3)), expected);
  EXPECT_GT(to_another, 0.1 * distance_to_others());
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Shape turned = test::transformed(sheet(1), 3, test::rotation(seed), {5, 6, 7});
    EXPECT_LT(distance_of_panoramas(panorama(turned), expected), 0.02 * to_another) << seed;
  }
}

}  // namespace
}  // namespace shapegauge

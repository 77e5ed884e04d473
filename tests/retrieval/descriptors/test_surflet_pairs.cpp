// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/retrieval/descriptors/surflet_pairs.h"
#include "shapegauge/retrieval/l1_distance.h"
#include "tests/retrieval/descriptors/default_settings.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

Eigen::VectorXf pairs_of(const Shape& shape, const SurfletPairsOptions& options = {}) {
  ProxySource source(shape);
  return surflet_pairs(source, options);
}

double distance_of(const Eigen::VectorXf& a, const Eigen::VectorXf& b) {
  return l1_distance({a.data(), static_cast<std::size_t>(a.size())}, {b.data(), static_cast<std::size_t>(b.size())});
}

/// The shares of the bins by one coordinate: 0 the distance, 1 to 3 the cosines.
Eigen::VectorXd marginal(const Eigen::VectorXf& features, const SurfletPairsOptions& options, std::size_t coordinate) {
  const std::array<Eigen::Index, 4> bins{options.distance_bins, options.angle_bins, options.angle_bins,
                                         options.angle_bins};
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(bins.at(coordinate));
  for (Eigen::Index i = 0; i < features.size(); ++i) {
    Eigen::Index rest = i;
    std::array<Eigen::Index, 4> bin{};
    for (std::size_t d = 4; d-- > 0;) {
      bin.at(d) = rest % bins.at(d);
      rest /= bins.at(d);
    }
    shares[bin.at(coordinate)] += static_cast<double>(features[i]) * features[i];
  }
  return shares;
}

TEST(SurfletPairs, SquaredFeaturesSumToOne) {
  const Eigen::VectorXf features = pairs_of(test::sphere(1, 3));
  EXPECT_EQ(features.size(), 10 * 5 * 5 * 5);
  EXPECT_NEAR(features.squaredNorm(), 1, 1e-5);
}

// On the unit sphere the chord t of two random points has the density t / 2 on [0, 2] and mean 4/3; both normals have
// the cosine t / 2 with the chord, and 1 - t^2 / 2 with each other.
TEST(SurfletPairs, OfASphereMatchTheDistributionOfRandomChords) {
  const SurfletPairsOptions options{.distance_bins = 12, .angle_bins = 8, .largest_distance = 3};
  const Eigen::VectorXf features = pairs_of(test::sphere(2, 5), options);
  std::array<Eigen::VectorXd, 4> expected{Eigen::VectorXd::Zero(12), Eigen::VectorXd::Zero(8), Eigen::VectorXd::Zero(8),
                                          Eigen::VectorXd::Zero(8)};
  const auto add = [](Eigen::VectorXd& shares, double position, double weight) {
    const auto bins = static_cast<double>(shares.size());
    const double at = std::clamp(position * bins - 0.5, 0.0, bins - 1);
    const auto below = std::min(static_cast<Eigen::Index>(at), shares.size() - 2);
    shares[below] += weight * (1 - (at - static_cast<double>(below)));
    shares[below + 1] += weight * (at - static_cast<double>(below));
  };
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double chord = 2 * std::sqrt((i + 0.5) / steps);  // equal shares of pairs
    add(expected[0], chord / (4.0 / 3) / options.largest_distance, 1.0 / steps);
    add(expected[1], std::abs(1 - chord * chord / 2), 1.0 / steps);
    add(expected[2], chord / 2, 1.0 / steps);
    add(expected[3], chord / 2, 1.0 / steps);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LT((marginal(features, options, k) - expected.at(k)).cwiseAbs().maxCoeff(), 0.015) << k;
  }
}

TEST(SurfletPairs, OfAFlatSheetHaveNormalsPerpendicularToConnectingLines) {
  const Shape sheet{Points{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, Triangles{{0, 1, 2}, {0, 2, 3}}};
  const SurfletPairsOptions options;
  const Eigen::VectorXf features = pairs_of(sheet, options);
  EXPECT_NEAR(marginal(features, options, 1)[4], 1, 1e-5);
  EXPECT_NEAR(marginal(features, options, 2)[0], 1, 1e-5);
  EXPECT_NEAR(marginal(features, options, 3)[0], 1, 1e-5);
}

TEST(SurfletPairs, HardlyChangeUnderMotionScaleReflectionAndMeshing) {
  const Shape capsule = test::capsule(0.3, 2, 24, 30);
  const Eigen::VectorXf expected = pairs_of(capsule);
  const double to_another = distance_of(pairs_of(test::torus(1, 0.4, 40, 30)), expected);
  Shape mirrored = capsule;
  mirrored.vertices.col(1) *= -1;
  EXPECT_LT(distance_of(pairs_of(mirrored), expected), 0.1 * to_another);
  EXPECT_LT(distance_of(pairs_of(test::transformed(capsule, 40, test::rotation(2), {1, 2, 3})), expected),
            0.1 * to_another);
  EXPECT_EQ(pairs_of(test::flipped(capsule)), expected);
  EXPECT_EQ(pairs_of(test::permuted(capsule, 3).shape), expected);
  EXPECT_LT(distance_of(pairs_of(test::soup(capsule)), expected), 0.1 * to_another);
  EXPECT_LT(distance_of(pairs_of(test::random_points(capsule, 10000, 1)), expected), 0.2 * to_another);
}

TEST(SurfletPairs, DoNotChangeWithASharedSurfaceProxy) {
  const Shape shape = test::capsule(0.3, 2, 16, 16);
  const Descriptor& one = descriptors().at("surflet_pairs");
  ProxySource shared(shape);
  shared.spectrum(30);
  const DescriptorSettings settings = default_settings(one);
  EXPECT_EQ(one.describe({.shape = shape, .fields = {}, .proxy = &shared}, {}, settings),
            one.describe({.shape = shape, .fields = {}}, {}, settings));
}

TEST(SurfletPairs, RejectShapesWithoutPairsAndOptionsOutOfRange) {
  EXPECT_THROW(pairs_of(Shape{}), InputError);
  EXPECT_THROW(pairs_of(Shape{Points::Zero(4, 3), {}}), InputError);
  EXPECT_THROW(pairs_of(test::sphere(1, 1), {.distance_bins = 1}), InputError);
  EXPECT_THROW(pairs_of(test::sphere(1, 1), {.angle_bins = 17}), InputError);
  EXPECT_THROW(pairs_of(test::sphere(1, 1), {.largest_distance = std::nan("")}), InputError);
}

}  // namespace
}  // namespace shapegauge

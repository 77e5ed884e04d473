// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/descriptors/silhouette.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using Image = std::vector<std::uint8_t>;
constexpr int pixels = 128;

/// Pixels whose centre (in the square from -1 to 1) is in a set.
template <typename Inside>
Image image_of(Inside inside) {
  Image image;
  for (int y = 0; y < pixels; ++y) {
    for (int x = 0; x < pixels; ++x) image.push_back(inside((2.0 * x + 1) / pixels - 1, (2.0 * y + 1) / pixels - 1));
  }
  return image;
}

/// The silhouette of a mesh.
Image silhouette_of(const Shape& mesh, const Eigen::Matrix3d& rotation) {
  return silhouette(mesh.vertices.transpose().cast<float>(), mesh.triangles, rotation, pixels);
}

std::size_t covered(const Image& image) { return static_cast<std::size_t>(std::ranges::count(image, 1)); }

std::size_t different(const Image& a, const Image& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

TEST(Silhouette, OfABoxIsARectangle) {
  const Image found = silhouette_of(test::box({1, 0.5, 1.2}, 3), Eigen::Matrix3d::Identity());
  const Image expected = image_of([](double x, double y) { return std::abs(x) <= 0.5 && std::abs(y) <= 0.25; });
  // Corners on the right and lower rim lie in the pixels beyond it.
  EXPECT_LE(different(found, expected), 8U);
}

TEST(Silhouette, OfASphereIsADisc) {
  // The disk is about a third of a pixel wider along its rim of 320 pixels, as vertices fill theirs.
  const Image found = silhouette_of(test::sphere(0.8, 4), test::rotation(1));
  EXPECT_NEAR(static_cast<double>(covered(found)), std::numbers::pi * 0.64 / 4 * pixels * pixels, 130);
}

TEST(Silhouette, OfAThinTriangleCoversOnePixel) {
  const Shape needle{.vertices = Points{{0.111, 0.2, 0}, {0.1111, 0.2, 0}, {0.111, 0.2001, 0}},
                     .triangles = Triangles{{0, 1, 2}}};
  EXPECT_EQ(covered(silhouette_of(needle, Eigen::Matrix3d::Identity())), 1U);
}

TEST(Silhouette, CoversPixelsCentredInATriangleOrContainingItsCorner) {
  // Compared with a test of each pixel, for corners at integer pixel positions.
  RandomNumbers random(1);
  for (int round = 0; round < 10; ++round) {
    Eigen::Matrix<float, 3, 3> corners = Eigen::Matrix<float, 3, 3>::Zero();
    for (float& x : corners.topRows<2>().reshaped()) {
      x = static_cast<float>(std::round(random.uniform(0, pixels * 256 - 1)) / (pixels * 128) - 1);
    }
    const auto inside = [&](double x, double y) {
      int positive = 0;
      int negative = 0;
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector2d a = corners.col(k).head<2>().cast<double>();
        const Eigen::Vector2d b = corners.col((k + 1) % 3).head<2>().cast<double>();
        const double side = (b - a).x() * (y - a.y()) - (b - a).y() * (x - a.x());
        positive += side > 0 ? 1 : 0;
        negative += side < 0 ? 1 : 0;
      }
      return positive == 0 || negative == 0;
    };
    const auto corner = [&](double x, double y) {
      for (int k = 0; k < 3; ++k) {
        const auto pixel_of = [](double at) { return std::floor((at + 1) / 2 * pixels); };
        if (pixel_of(corners(0, k)) == pixel_of(x) && pixel_of(corners(1, k)) == pixel_of(y)) return true;
      }
      return false;
    };
    const Image expected = image_of([&](double x, double y) { return inside(x, y) || corner(x, y); });
    EXPECT_EQ(silhouette(corners, Triangles{{0, 1, 2}}, Eigen::Matrix3d::Identity(), pixels), expected) << round;
  }
}

TEST(SilhouetteFeatures, OfTheFullDiscAreZero) {
  const auto features = SilhouetteFeatures(pixels)(image_of([](double x, double y) { return x * x + y * y <= 1; }));
  for (std::size_t k = 0; k < silhouette_feature_count; ++k) EXPECT_LT(features[k], 0.02) << k;
}

TEST(SilhouetteFeatures, OfADiscMatchItsAnalyticZernikeMoments) {
  const double r = 0.6;
  const auto features =
      SilhouetteFeatures(pixels)(image_of([&](double x, double y) { return x * x + y * y <= r * r; }));
  // Without repetition there are orders 2 (after 1,1), 4, ...: of 2, (3 / pi) times the integral of 2 rho^2 - 1.
  EXPECT_NEAR(features[1], std::abs(3 * (std::pow(r, 4) - r * r)), 0.01);
  // Order 4: (5 / pi) times the integral of 6 rho^4 - 6 rho^2 + 1.
  EXPECT_NEAR(features[5], std::abs(5 * (2 * std::pow(r, 6) - 3 * std::pow(r, 4) + r * r)), 0.01);
  EXPECT_LT(features[0], 0.01);  // 1,1
  EXPECT_LT(features[2], 0.01);  // 2,2
}

TEST(SilhouetteFeatures, DoNotChangeIfTheImageIsRotatedOrMirrored) {
  const auto shape = [](double x, double y) { return std::abs(x) <= 0.7 && y >= -0.2 && y <= 0.3 + 0.2 * x; };
  const SilhouetteFeatures features_of(pixels);
  const auto expected = features_of(image_of(shape));
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const auto turned = features_of(image_of([&](double x, double y) { return shape(c * x + s * y, c * y - s * x); }));
  const auto mirrored = features_of(image_of([&](double x, double y) { return shape(-x, y); }));
  for (std::size_t k = 0; k < silhouette_feature_count; ++k) {
    EXPECT_NEAR(turned[k], expected[k], 0.02) << k;
    EXPECT_NEAR(mirrored[k], expected[k], 0.02) << k;
  }
}

TEST(SilhouetteFeatures, OutlineOfASquareHasOnlyFourfoldFourierCoefficients) {
  const auto features =
      SilhouetteFeatures(pixels)(image_of([](double x, double y) { return std::max(std::abs(x), std::abs(y)) < 0.6; }));
  const auto coefficient = [&](std::size_t k) { return features[zernike_moments + k - 1]; };
  for (const std::size_t k : {1U, 2U, 3U, 5U, 6U, 7U, 9U}) EXPECT_LT(coefficient(k), 0.01) << k;
  // At arc length s from a side's middle the distance is sqrt(1 + s^2); its fourth coefficient by quadrature.
  EXPECT_NEAR(coefficient(4), 0.0786, 0.01);
}

TEST(SilhouetteFeatures, OutlineFeaturesUseOnlyTheLongestOutline) {
  const auto large = [](double x, double y) { return std::max(std::abs(x + 0.3), std::abs(y)) < 0.4; };
  const SilhouetteFeatures features_of(pixels);
  const auto alone = features_of(image_of(large));
  const auto both = features_of(image_of(
      [&](double x, double y) { return large(x, y) || (std::abs(x - 0.5) < 0.05 && std::abs(y + 0.5) < 0.05); }));
  for (std::size_t k = zernike_moments; k < silhouette_feature_count; ++k) EXPECT_EQ(both[k], alone[k]);
}

TEST(SilhouetteFeatures, AreFiniteForEmptyImagesAndSinglePixels) {
  const SilhouetteFeatures features_of(pixels);
  for (const double feature : features_of(Image(pixels * pixels, 0))) EXPECT_EQ(feature, 0);
  Image single(pixels * pixels, 0);
  single[4000] = 1;
  for (const double feature : features_of(single)) EXPECT_TRUE(std::isfinite(feature));
  EXPECT_THROW(static_cast<void>(features_of(Image(7))), ArgumentError);
}

}  // namespace
}  // namespace shapegauge

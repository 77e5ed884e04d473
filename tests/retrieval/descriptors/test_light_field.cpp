// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/base/decompositions.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/retrieval/descriptors/light_field.h"
#include "shapegauge/retrieval/descriptors/silhouette.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

double distance_of_light_fields(const Eigen::VectorXf& a, const Eigen::VectorXf& b) {
  return light_field_distance({a.data(), static_cast<std::size_t>(a.size())},
                              {b.data(), static_cast<std::size_t>(b.size())});
}

constexpr LightFieldOptions coarse = {.pixels = 64};

TEST(LightFieldDescriptor, RotatedShapeIsMuchCloserThanOtherShapes) {
  const Shape bar = test::box({1, 2, 4}, 2);
  const Eigen::VectorXf of_bar = light_field(bar, coarse);
  const std::vector<Eigen::VectorXf> others = {light_field(test::box({1, 1, 1}, 2), coarse),
                                               light_field(test::sphere(1, 3), coarse),
                                               light_field(test::box({1, 4, 4}, 2), coarse)};
  double nearest_other = 1e9;
  for (const Eigen::VectorXf& other : others)
    nearest_other = std::min(nearest_other, distance_of_light_fields(of_bar, other));
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Shape turned = test::transformed(bar, 3, test::rotation(seed), {1, 2, 3});
    EXPECT_LT(distance_of_light_fields(light_field(turned, coarse), of_bar), 0.35 * nearest_other) << seed;
  }
}

TEST(LightFieldDescriptor, HardlyChangesUnderRotationsThatPermuteItsViews) {
  // By a third of a turn about a vertex: a set's views are permuted.
  const Shape bar = test::box({1, 2, 4}, 2);
  const Eigen::Matrix3d third =
      Eigen::AngleAxisd(2 * std::numbers::pi / 3, Eigen::Vector3d(1, 1, 1).normalized()).toRotationMatrix();
  const Eigen::VectorXf before = light_field(bar);
  const Eigen::VectorXf after = light_field(test::transformed(bar, 1, third, {0, 0, 0}));
  // Only pixels on the rims differ, as each view is turned about its axis.
  EXPECT_LT(distance_of_light_fields(before, after), 0.6);
  EXPECT_GT((before - after).cwiseAbs().sum() / 255, 10 * distance_of_light_fields(before, after));
}

TEST(LightFieldDescriptor, OfASphereHasFeaturesNearZero) {
  const Eigen::VectorXf found = light_field(test::sphere(3, 4));
  ASSERT_EQ(found.size(), 4500);
  EXPECT_LE(found.maxCoeff(), 10);
  EXPECT_EQ(found, found.array().round().matrix());
}

TEST(LightFieldDescriptor, DistanceIsSymmetricAndZeroForEqualShapes) {
  const Eigen::VectorXf a = light_field(test::box({1, 2, 4}, 2), coarse);
  const Eigen::VectorXf b = light_field(test::capsule(0.3, 1, 12, 12), coarse);
  EXPECT_EQ(distance_of_light_fields(a, a), 0);
  EXPECT_EQ(distance_of_light_fields(a, b), distance_of_light_fields(b, a));
  EXPECT_GT(distance_of_light_fields(a, b), 0);
}

TEST(LightFieldDescriptor, DoesNotDependOnFaceOrientationOrDuplicatedVertices) {
  const Shape bar = test::box({1, 2, 4}, 2);
  EXPECT_EQ(light_field(test::flipped(test::soup(bar)), coarse), light_field(bar, coarse));
}

TEST(LightFieldDescriptor, CloudIsMuchCloserToItsMeshThanToOtherMeshes) {
  const Shape bar = test::box({1, 2, 4}, 2);
  const Eigen::VectorXf cloud = light_field(test::random_points(bar, 10'000, 1));
  double nearest_other = 1e9;
  for (const Shape& other : {test::box({1, 1, 1}, 2), test::sphere(1, 3), test::box({1, 4, 4}, 2)}) {
    nearest_other = std::min(nearest_other, distance_of_light_fields(cloud, light_field(other)));
  }
  EXPECT_LT(distance_of_light_fields(cloud, light_field(bar)), 0.2 * nearest_other);
}

TEST(LightFieldDescriptor, RefusesOptionsOutOfRangeAndShapesWithoutArea) {
  const Shape ball = test::sphere(1, 1);
  EXPECT_THROW(light_field(Shape{Points::Zero(5, 3), {}}), InputError);
  EXPECT_THROW(light_field(ball, {.pixels = 8}), InputError);
  Shape line = ball;
  line.vertices.rightCols<2>().setZero();
  EXPECT_THROW(light_field(line), InputError);
  EXPECT_THROW(distance_of_light_fields(Eigen::VectorXf::Zero(5), Eigen::VectorXf::Zero(5)), ArgumentError);
  const Eigen::VectorXf zeros = Eigen::VectorXf::Zero(4500);
  for (const float no_byte : {-1.0F, 256.0F, std::nanf("")}) {
    EXPECT_THROW(distance_of_light_fields(zeros, zeros.array() + no_byte), ArgumentError) << no_byte;
  }
}

TEST(LightFieldDescriptor, BeginsWithTheRoundedFeaturesOfTheFirstView) {
  // A box whose corners are on the unit sphere, seen along the first vertex of the dodecahedron.
  const Shape box = test::box(Eigen::Vector3d(1, 2, 4) * 2 / std::sqrt(21.0), 1);
  const Eigen::Matrix3d rotation = rotation_between({1, 1, 1}, Eigen::Vector3d::UnitZ());
  const auto features = SilhouetteFeatures(coarse.pixels)(
      silhouette(box.vertices.transpose().cast<float>(), box.triangles, rotation, coarse.pixels));
  const Eigen::VectorXf found = light_field(box, coarse);
  for (std::size_t k = 0; k < features.size(); ++k) {
    EXPECT_EQ(found[static_cast<Eigen::Index>(k)], std::round(255 * std::min(features[k], 1.0))) << k;
  }
}

}  // namespace
}  // namespace shapegauge

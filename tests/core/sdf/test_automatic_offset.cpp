// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/preparation/gap_size.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(AutomaticOffset, IsTheMinimumForCleanClosedMeshes) {
  for (const Shape& shape : {test::sphere(1, 3), test::torus(2, 0.7, 30, 60)}) {
    const AutomaticOffset chosen = automatic_offset(shape);
    EXPECT_EQ(chosen.offset, 0.01);
    EXPECT_EQ(chosen.gap, 0);
    EXPECT_EQ(chosen.noise, 0);
    EXPECT_TRUE(chosen.sufficient);
  }
}

TEST(AutomaticOffset, ClosesTheGapsOfACrackedMesh) {
  RandomNumbers random(1);
  const Shape torus = test::torus(2, 0.7, 48, 96);
  const Shape cracked = remove_faces(torus, 0.2, random);
  const AutomaticOffset chosen = automatic_offset(cracked);
  EXPECT_NEAR(chosen.gap, 1.1 * gap_sizes(cracked).closable / bounding_box_diagonal(cracked), 1e-12);
  EXPECT_GT(chosen.gap, 0.01);
  EXPECT_EQ(chosen.offset, chosen.gap);
  EXPECT_TRUE(chosen.sufficient);
  const auto mean_with = [&](const Shape& shape) {
    return offset_sdf(shape, sample_shape(cracked, SampleSite::faces), {.offset = chosen.offset}).values.mean();
  };
  EXPECT_NEAR(mean_with(cracked), mean_with(torus), 0.02);
}

TEST(AutomaticOffset, IsTwiceTheNoiseLevelOfANoisyMesh) {
  RandomNumbers random(1);
  const Shape noisy =
      vertex_noise(test::sphere(1, 5), {.amplitude = 0.01, .distribution = NoiseDistribution::gaussian}, random);
  const AutomaticOffset chosen = automatic_offset(noisy);
  EXPECT_EQ(chosen.gap, 0);
  EXPECT_NEAR(chosen.noise, 0.02, 0.003);
  EXPECT_EQ(chosen.offset, chosen.noise);
}

TEST(AutomaticOffset, ClosesARandomCloudOfASphere) {
  // Without a leak no value is far below the diameter: a ray through a hole would end half way, in the inside.
  const Shape sphere = test::sphere(1, 5);
  for (const auto& [points, seed] : {std::pair(3000, 2), {3000, 3}, {10000, 4}}) {
    const Shape cloud = test::random_points(sphere, points, static_cast<std::uint64_t>(seed));
    const AutomaticOffset chosen = automatic_offset(cloud);
    EXPECT_TRUE(chosen.sufficient);
    EXPECT_EQ(chosen.noise, 0);
    const OffsetSdfResult result =
        offset_sdf(cloud, sample_shape(cloud, SampleSite::vertices), {.offset = chosen.offset});
    EXPECT_GT(result.values.minCoeff(), 1.5) << points;
    EXPECT_NEAR(result.values.mean(), 2, 0.04) << points;
    EXPECT_EQ(result.outcomes.undecided, 0U);
    // A third of it leaks.
    const OffsetSdfResult leaking =
        offset_sdf(cloud, sample_shape(cloud, SampleSite::vertices), {.offset = chosen.offset / 3});
    EXPECT_LT(leaking.values.minCoeff(), 1) << points;
  }
}

TEST(AutomaticOffset, ReportsIfTheMaximumOffsetDoesNotCloseTheGaps) {
  const Shape sparse = test::random_points(test::sphere(1, 4), 300, 1);
  const AutomaticOffset chosen = automatic_offset(sparse);
  EXPECT_GT(chosen.gap, 0.05);
  EXPECT_EQ(chosen.offset, 0.05);
  EXPECT_FALSE(chosen.sufficient);
}

TEST(AutomaticOffset, DoesNotDependOnTheScaleOfTheShape) {
  const Shape cloud = test::random_points(test::sphere(1, 4), 3000, 1);
  const double offset = automatic_offset(cloud).offset;
  for (const double scale : {1e-30, 1e30}) {
    const Shape scaled = test::transformed(cloud, scale, Eigen::Matrix3d::Identity(), {0, 0, 0});
    EXPECT_NEAR(automatic_offset(scaled).offset, offset, 1e-9);
  }
}

TEST(AutomaticOffset, RejectsShapesWithoutExtentOrWithInvalidIndices) {
  EXPECT_THROW(automatic_offset(Shape{}), InputError);
  EXPECT_THROW(automatic_offset(Shape{Points::Ones(5, 3), {}}), InputError);
  Shape unusable = test::sphere(1, 1);
  unusable.triangles(0, 0) = 4711;
  EXPECT_THROW(automatic_offset(unusable), InputError);
}

}  // namespace
}  // namespace shapegauge

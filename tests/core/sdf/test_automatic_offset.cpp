#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/preparation/gap_size.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(AutomaticOffset, OfACleanClosedMeshIsTheLeast) {
  for (const Shape& shape : {test::sphere(1, 3), test::torus(2, 0.7, 30, 60)}) {
    const AutomaticOffset chosen = automatic_offset(shape, {.least = 0.007, .most = 0.04});
    EXPECT_EQ(chosen.offset, 0.007);
    EXPECT_EQ(chosen.gap, 0);
    EXPECT_EQ(chosen.noise, 0);
    EXPECT_TRUE(chosen.sufficient);
  }
}

TEST(AutomaticOffset, OfACrackedMeshClosesItsGaps) {
  const Shape torus = test::torus(2, 0.7, 12, 24);
  RandomNumbers random(1);
  const Shape cracked = remove_faces(torus, 0.1, random);
  const AutomaticOffset chosen = automatic_offset(cracked, {.most = 1});
  EXPECT_NEAR(chosen.gap, 1.1 * gap_size(cracked) / bounding_box_diagonal(cracked), 1e-12);
  EXPECT_GT(chosen.gap, 0.01);
  EXPECT_EQ(chosen.offset, chosen.gap);
  EXPECT_TRUE(chosen.sufficient);
  // The widest gap does not depend on the bound; the gap that the offset closes does.
  const AutomaticOffset bounded = automatic_offset(cracked, {.most = chosen.gap / 2});
  EXPECT_EQ(bounded.widest_gap, chosen.widest_gap);
  EXPECT_NEAR(bounded.widest_gap, chosen.gap / 1.1, 1e-12);
  EXPECT_LT(bounded.gap, chosen.gap / 2);
}

TEST(AutomaticOffset, OfANoisyMeshIsTwiceTheNoise) {
  RandomNumbers random(1);
  const Shape noisy =
      vertex_noise(test::sphere(1, 5), {.amplitude = 0.01, .distribution = NoiseDistribution::gaussian}, random);
  const AutomaticOffset chosen = automatic_offset(noisy);
  EXPECT_EQ(chosen.gap, 0);
  EXPECT_NEAR(chosen.noise, 0.02, 0.003);
  EXPECT_EQ(chosen.offset, chosen.noise);
}

TEST(AutomaticOffset, FollowsFromDiagnosticsAtAnyScale) {
  RandomNumbers random(1);
  const Shape sphere = test::sphere(1, 5);
  const Shape cracked = remove_faces(test::torus(2, 0.7, 24, 48), 0.1, random);
  const Shape noisy = vertex_noise(sphere, {.amplitude = 0.01, .distribution = NoiseDistribution::gaussian}, random);
  for (const Shape& shape : {sphere, cracked, noisy, test::random_points(sphere, 3000, 2)}) {
    Shape scaled = shape;
    scaled.vertices *= 0.3;
    const AutomaticOffset expected = automatic_offset(scaled);
    const AutomaticOffset known = automatic_offset(scaled, diagnose(shape));
    EXPECT_EQ(known.gap, expected.gap);
    EXPECT_EQ(known.widest_gap, expected.widest_gap);
    EXPECT_NEAR(known.noise, expected.noise, 1e-12);
    EXPECT_NEAR(known.offset, expected.offset, 1e-12);
    EXPECT_EQ(known.sufficient, expected.sufficient);
  }
}

TEST(AutomaticOffset, ClosesARandomCloudOfASphere) {
  // Without a leak no value is far below the diameter: a ray through a hole would end half way, in the inside.
  const Shape sphere = test::sphere(1, 5);
  for (const auto& [points, seed] : {std::pair(1000, 1), {3000, 2}, {3000, 3}, {10000, 4}}) {
    const Shape cloud = test::random_points(sphere, points, static_cast<std::uint64_t>(seed));
    const AutomaticOffset chosen = automatic_offset(cloud, {.most = 0.2});
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

TEST(AutomaticOffset, SaysWhereTheMostIsNotEnough) {
  const Shape sparse = test::random_points(test::sphere(1, 4), 300, 1);
  const AutomaticOffset chosen = automatic_offset(sparse);
  EXPECT_GT(chosen.gap, 0.05);
  EXPECT_EQ(chosen.offset, 0.05);
  EXPECT_FALSE(chosen.sufficient);
}

TEST(AutomaticOffset, GoesWithTheShapeWhateverTheScale) {
  const Shape cloud = test::random_points(test::sphere(1, 4), 3000, 1);
  const double offset = automatic_offset(cloud).offset;
  for (const double scale : {1e-30, 1e30}) {
    const Shape scaled = test::transformed(cloud, scale, Eigen::Matrix3d::Identity(), {0, 0, 0});
    EXPECT_NEAR(automatic_offset(scaled).offset, offset, 1e-9);
  }
}

TEST(AutomaticOffset, RefusesWhatHasNoExtentAndBoundsOutOfOrder) {
  const Shape sphere = test::sphere(1, 1);
  EXPECT_THROW(automatic_offset({}), InputError);
  EXPECT_THROW(automatic_offset({Points::Ones(5, 3), {}}), InputError);
  EXPECT_THROW(automatic_offset(sphere, {.least = 0.1, .most = 0.05}), InputError);
  EXPECT_THROW(automatic_offset(sphere, {.least = 0, .most = 0.05}), InputError);
  EXPECT_THROW(automatic_offset(sphere, {.least = std::nan(""), .most = 0.05}), InputError);
  Shape unusable = sphere;
  unusable.triangles(0, 0) = 4711;
  EXPECT_THROW(automatic_offset(unusable), InputError);
}

}  // namespace
}  // namespace shapegauge

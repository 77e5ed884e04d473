#include <gtest/gtest.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/perturbation/flip_orientation.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

Shape turned(const Shape& shape, double fraction, std::uint64_t seed) {
  RandomNumbers random(seed);
  return flip_orientation(shape, fraction, random);
}

TEST(FlipOrientation, TurnsExactlyTheFractionOver) {
  const Shape sphere = test_shapes::sphere(1, 3);
  const Points before = sample_shape(sphere, SampleSite::faces).normals;
  for (const auto& [fraction, expected] : {std::pair{0.0, 0}, {0.25, 320}, {1.0, 1280}}) {
    const Points after = sample_shape(turned(sphere, fraction, 1), SampleSite::faces).normals;
    const Eigen::VectorXd cosines = before.cwiseProduct(after).rowwise().sum();
    EXPECT_EQ((cosines.array() < -0.999).count(), expected);
    EXPECT_EQ((cosines.array() > 0.999).count(), 1280 - expected);
  }
  EXPECT_NE(turned(sphere, 0.25, 1).triangles, turned(sphere, 0.25, 2).triangles);
}

TEST(FlipOrientation, TurnsTheNormalsOfACloud) {
  Shape cloud;
  cloud.vertices = test_shapes::sphere(1, 1).vertices;
  EXPECT_EQ(turned(cloud, 1, 1).vertices, cloud.vertices);
  cloud.normals = cloud.vertices;
  EXPECT_EQ(turned(cloud, 1, 1).normals, -cloud.vertices);
}

TEST(FlipOrientation, RefusesWhatIsNoFraction) {
  EXPECT_THROW(turned(test_shapes::box({1, 1, 1}, 1), 1.5, 1), InputError);
}

}  // namespace
}  // namespace shapegauge

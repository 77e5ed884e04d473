#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/perturbation/vertex_noise.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

Shape noisy(const Shape& shape, const VertexNoiseOptions& options, std::uint64_t seed) {
  RandomNumbers random(seed);
  return vertex_noise(shape, options, random);
}

TEST(VertexNoise, GaussianCoordinatesHaveTheAmplitudeAsStandardDeviation) {
  const Shape sphere = test_shapes::sphere(3, 6);
  const double amplitude = 0.02 * bounding_box_diagonal(sphere);
  const Points moves =
      noisy(sphere, {.amplitude = 0.02, .distribution = NoiseDistribution::gaussian}, 1).vertices - sphere.vertices;
  const auto n = static_cast<double>(moves.size());
  // Five standard deviations of the mean and of the variance.
  EXPECT_NEAR(moves.mean(), 0, 5 * amplitude / std::sqrt(n));
  EXPECT_NEAR(moves.squaredNorm() / n / (amplitude * amplitude), 1, 5 * std::sqrt(2 / n));
}

TEST(VertexNoise, UniformDisplacementsFillTheBall) {
  const Shape sphere = test_shapes::sphere(3, 6);
  const double radius = 0.02 * bounding_box_diagonal(sphere);
  const VertexNoiseOptions options{.amplitude = 0.02, .distribution = NoiseDistribution::uniform};
  const Points moves = noisy(sphere, options, 1).vertices - sphere.vertices;
  const auto n = static_cast<double>(moves.rows());
  EXPECT_LE(moves.rowwise().norm().maxCoeff(), radius * (1 + 1e-12));
  // The mean of the squared distance from the centre is 3/5, its variance 3/7 - 9/25.
  EXPECT_NEAR(moves.squaredNorm() / n / (radius * radius), 0.6, 5 * std::sqrt((3. / 7 - 9. / 25) / n));
  EXPECT_LT(moves.colwise().mean().norm(), 5 * radius * std::sqrt(0.6 / n));
}

TEST(VertexNoise, DependsOnTheSeedAndIsProportionalToSize) {
  const Shape box = test_shapes::box({1, 2, 3}, 4);
  EXPECT_EQ(noisy(box, {}, 7).vertices, noisy(box, {}, 7).vertices);
  EXPECT_NE(noisy(box, {}, 7).vertices, noisy(box, {}, 8).vertices);
  Shape large = box;
  large.vertices *= 1024;
  EXPECT_LT((noisy(large, {}, 7).vertices / 1024 - noisy(box, {}, 7).vertices).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(noisy(box, {}, 7).triangles, box.triangles);
  EXPECT_EQ(noisy(box, {.amplitude = 0}, 7).vertices, box.vertices);
}

TEST(VertexNoise, MovesThePointsOfACloud) {
  Shape cloud;
  cloud.vertices = test_shapes::sphere(1, 2).vertices;
  const Points moves = noisy(cloud, {.amplitude = 0.1}, 1).vertices - cloud.vertices;
  EXPECT_GT(moves.rowwise().norm().minCoeff(), 0);
}

TEST(VertexNoise, RefusesAShapeWithoutExtentAndAnImpossibleAmplitude) {
  Shape point;
  point.vertices = Points::Ones(5, 3);
  EXPECT_THROW(noisy(point, {}, 1), InputError);
  EXPECT_THROW(noisy(Shape{}, {}, 1), InputError);
  for (const double amplitude : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(noisy(test_shapes::box({1, 1, 1}, 1), {.amplitude = amplitude}, 1), InputError);
  }
}

}  // namespace
}  // namespace shapegauge

#include <gtest/gtest.h>
#include <limits>

#include "shapegauge/core/perturbation/flip_orientation.h"
#include "shapegauge/core/perturbation/random_vectors.h"
#include "shapegauge/core/perturbation/vertex_noise.h"
#include "shapegauge/core/preparation/noise_level.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

NoiseLevel level_of(const Shape& shape) { return noise_level(shape, vertex_neighbours(shape)); }

bool is_noisy(const Shape& shape) { return is_noisy(level_of(shape), vertex_neighbours(shape)); }

/// Noise along the normal only, of that standard deviation.
Shape with_normal_noise(Shape sphere, double deviation) {
  RandomNumbers random(5);
  for (Eigen::Index i = 0; i < sphere.vertices.rows(); ++i) {
    sphere.vertices.row(i) *= 1 + deviation * gaussian_vector(random).x() / sphere.vertices.row(i).norm();
  }
  return sphere;
}

/// Noise in all directions, of that standard deviation along each.
Shape with_isotropic_noise(const Shape& shape, double deviation) {
  RandomNumbers random(3);
  return vertex_noise(
      shape, {.amplitude = deviation / bounding_box_diagonal(shape), .distribution = NoiseDistribution::gaussian},
      random);
}

TEST(NoiseLevel, IsTheDeviationOfTheNoiseOfASphere) {
  // The estimate's own error: 1.2 / sqrt(n), 1 % here; what the smoothing keeps of the noise lowers it by some per
  // cent. An edge is 0.038 long.
  const Shape sphere = test_shapes::sphere(1, 5);
  for (const double deviation : {0.003, 0.008, 0.015}) {
    for (const Shape& noisy : {with_isotropic_noise(sphere, deviation), with_normal_noise(sphere, deviation)}) {
      const NoiseLevel level = level_of(noisy);
      EXPECT_NEAR(level.deviation, deviation, 0.08 * deviation);
      EXPECT_NEAR(level.edge_length, 0.037, 0.002);
      EXPECT_LT(level.agreement, 0.5);
      EXPECT_EQ(is_noisy(noisy), deviation > 0.004) << level.relative();
    }
  }
}

TEST(NoiseLevel, FindsNoNoiseOnCleanShapes) {
  const std::vector<Shape> clean = {
      test_shapes::sphere(1, 3),
      test_shapes::sphere(1, 5),
      test_shapes::torus(2, 0.7, 60, 120),
      test_shapes::torus(2, 0.7, 12, 50),  // long triangles
      test_shapes::box({1, 2, 3}, 12),
      test_shapes::box({1, 1, 1}, 30),
      test_shapes::box({1, 40, 0.01}, 12),  // a strip of needles
      test_shapes::capsule(0.5, 4, 48, 12),
      test_shapes::capsule(0.5, 400, 48, 12),
      test_shapes::joined({test_shapes::box({1, 1, 5}, 10), test_shapes::box({5, 1, 1}, 10)}),
  };
  for (std::size_t i = 0; i < clean.size(); ++i) EXPECT_FALSE(is_noisy(clean[i])) << i;
}

TEST(NoiseLevel, DoesNotDependOnTheOrientation) {
  const Shape noisy = with_isotropic_noise(test_shapes::torus(2, 0.7, 40, 80), 0.02);
  RandomNumbers random(1);
  const NoiseLevel clean = level_of(noisy);
  for (const Shape& turned : {test_shapes::flipped(noisy), flip_orientation(noisy, 0.5, random)}) {
    const NoiseLevel level = level_of(turned);
    EXPECT_NEAR(level.deviation, clean.deviation, 1e-9 * clean.deviation);
    EXPECT_EQ(level.edge_length, clean.edge_length);
    EXPECT_NEAR(level.agreement, clean.agreement, 1e-3);  // normals across each other are alike by their signs only
  }
}

TEST(NoiseLevel, GoesWithTheScaleAndNotWithThePlace) {
  const Shape noisy = with_isotropic_noise(test_shapes::torus(2, 0.7, 40, 80), 0.02);
  const NoiseLevel level = level_of(noisy);
  for (const double scale : {1e-30, 1e-4, 1e30}) {
    const Shape moved =
        test_shapes::transformed(noisy, scale, test_shapes::rotation(2), scale * Eigen::Vector3d(5, 6, 7));
    const NoiseLevel found = level_of(moved);
    EXPECT_NEAR(found.deviation / scale, level.deviation, 1e-9 * level.deviation);
    EXPECT_NEAR(found.edge_length / scale, level.edge_length, 1e-9 * level.edge_length);
    EXPECT_NEAR(found.agreement, level.agreement, 1e-3);
  }
}

TEST(NoiseLevel, OfASoupIsThatOfItsMesh) {
  // Each vertex counts as often as it has triangles, six times as a rule.
  const Shape noisy = with_isotropic_noise(test_shapes::torus(2, 0.7, 40, 80), 0.02);
  const NoiseLevel mesh = level_of(noisy);
  const NoiseLevel soup = level_of(test_shapes::soup(noisy));
  EXPECT_NEAR(soup.deviation, mesh.deviation, 1e-6 * mesh.deviation);
  EXPECT_NEAR(soup.agreement, mesh.agreement, 1e-6);
  EXPECT_TRUE(is_noisy(test_shapes::soup(noisy)));
  const Shape far = test_shapes::transformed(test_shapes::soup(test_shapes::sphere(1, 3)), 1,
                                             Eigen::Matrix3d::Identity(), {1e7, 1e7, 1e7});
  EXPECT_FALSE(is_noisy(far));
}

TEST(NoiseLevel, SaysNothingOfFewVertices) {
  const Shape few = with_isotropic_noise(test_shapes::sphere(1, 2), 0.1);  // 162 vertices
  EXPECT_GE(level_of(few).relative(), 0.1);
  EXPECT_FALSE(is_noisy(few));
  Shape padded = few;
  padded.vertices.conservativeResize(1000, 3);
  padded.vertices.bottomRows(1000 - 162).setOnes();
  EXPECT_FALSE(is_noisy(padded));
  EXPECT_FALSE(is_noisy(test_shapes::soup(few)));
}

TEST(NoiseLevel, IsZeroForACloud) {
  const NoiseLevel level = level_of({test_shapes::sphere(1, 3).vertices, {}});
  EXPECT_EQ(level.deviation, 0);
  EXPECT_EQ(level.edge_length, 0);
  EXPECT_EQ(level.relative(), 0);
}

}  // namespace
}  // namespace shapegauge

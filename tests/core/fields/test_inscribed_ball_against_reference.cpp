// SPDX-License-Identifier: GPL-3.0-or-later
// Inscribed balls against their definition, evaluated literally.

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/fields/inscribed_ball.h"
#include "shapegauge/core/io/shape_file.h"
#include "tests/oracle/inscribed_ball_reference.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Compares `count` samples, spread over the faces, for both sides of the surface and two angles.
void expect_reference(const Shape& shape, Eigen::Index count) {
  const Samples samples = sample_shape(shape, SampleSite::faces);
  for (const double angle : {60.0, 105.0}) {
    const TouchingBalls balls(shape, {.separation_angle_degrees = angle});
    for (const BallSide side : {BallSide::inside, BallSide::outside}) {
      const Eigen::VectorXd diameters = balls.diameters(samples, side);
      const double sign = side == BallSide::inside ? -1 : 1;
      for (Eigen::Index k = 0; k < count; ++k) {
        const Eigen::Index i = k * (diameters.size() / count);
        if (samples.normals.row(i).isZero(0)) continue;
        const double expected = test::touching_ball_by_definition(shape, samples.points.row(i).transpose(),
                                                                  sign * samples.normals.row(i).transpose(), angle);
        if (std::isnan(expected)) {
          EXPECT_TRUE(std::isnan(diameters[i])) << i << ", " << angle;
        } else {
          EXPECT_NEAR(diameters[i], expected, 1.1e-3 * expected) << i << ", " << angle;
        }
      }
    }
  }
}

TEST(InscribedBallAgainstReference, MatchesTheDefinitionOnSmoothAndAngularShapes) {
  expect_reference(test::torus(2, 0.7, 40, 24), 40);
  expect_reference(test::sphere(1, 5), 10);
  expect_reference(test::box({3, 2, 1}, 5), 60);
}

TEST(InscribedBallAgainstReference, MatchesTheDefinitionOnTwoNoisyBodies) {
  Shape upper = test::box({30, 20, 3}, 20);
  upper.vertices.col(2).array() += 4;
  Shape shape = test::joined({test::box({30, 20, 3}, 20), upper});
  RandomNumbers random(3);
  for (double& coordinate : shape.vertices.reshaped()) coordinate += random.uniform(-0.005, 0.005);
  expect_reference(shape, 60);
}

TEST(InscribedBallAgainstReference, MatchesTheDefinitionForTrianglesOfMixedOrientation) {
  Shape shape = test::torus(2, 0.7, 30, 18);
  for (Eigen::Index f = 0; f < shape.triangles.rows(); f += 3) {
    std::swap(shape.triangles(f, 0), shape.triangles(f, 1));
  }
  expect_reference(shape, 60);
}

/// Slivers of a tessellated cylinder whose coordinates are rounded as in a binary STL file.
TEST(InscribedBallAgainstReference, MatchesTheDefinitionOnSliversInSinglePrecision) {
  Shape shape = test::capsule(1.5, 60, 400, 3);
  shape.vertices = shape.vertices.cast<float>().cast<double>();
  const Eigen::VectorXd diameters = inscribed_ball(shape, sample_shape(shape, SampleSite::faces));
  EXPECT_GT(diameters.minCoeff(), 2.5);
  expect_reference(shape, 40);
}

TEST(InscribedBallAgainstReference, MatchesTheDefinitionOnScannedMeshes) {
  const char* const data = std::getenv("SHAPEGAUGE_DATA");
  if (data == nullptr) GTEST_SKIP() << "SHAPEGAUGE_DATA names no folder with real meshes";
  for (const std::string name : {"bunny.off", "armadillo.obj", "kitten.obj"}) {
    SCOPED_TRACE(name);
    expect_reference(read_shape(std::filesystem::path(data) / "models" / name), 25);
  }
}

}  // namespace
}  // namespace shapegauge

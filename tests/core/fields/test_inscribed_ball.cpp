// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/fields/inscribed_ball.h"
#include "shapegauge/core/spatial/closest_point.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

Eigen::VectorXd at_faces(const Shape& shape,
                         double separation_angle_degrees = InscribedBallOptions{}.separation_angle_degrees) {
  return inscribed_ball(shape, sample_shape(shape, SampleSite::faces),
                        {.separation_angle_degrees = separation_angle_degrees});
}

TEST(InscribedBall, OfASphereHasItsDiameter) {
  const Shape shape = test::sphere(2, 4);
  const Eigen::VectorXd diameters = at_faces(shape);
  EXPECT_NEAR(diameters.minCoeff(), 4, 0.06);
  EXPECT_LE(diameters.maxCoeff(), 4);
}

TEST(InscribedBall, DiameterIsTheBoxThicknessExceptNearEdges) {
  const Shape shape = test::box({4, 3, 1}, 12);
  const Samples samples = sample_shape(shape, SampleSite::faces);
  const Eigen::VectorXd diameters = inscribed_ball(shape, samples, {.separation_angle_degrees = 60});
  const Eigen::Array3d half(2, 1.5, 0.5);
  for (Eigen::Index i = 0; i < diameters.size(); ++i) {
    Eigen::Array3d to_side = half - samples.points.row(i).transpose().array().abs();
    Eigen::Index side = 0;
    to_side.minCoeff(&side);
    double expected = 2 * half[side];
    for (Eigen::Index k = 0; k < 3; ++k) {
      if (k != side) expected = std::min(expected, 2 * to_side[k]);
    }
    EXPECT_NEAR(diameters[i], expected, 1e-9) << i;
  }
  // Sides at right angles do not count as contacts beyond a right angle.
  const Eigen::VectorXd walls = at_faces(shape);
  for (Eigen::Index i = 0; i < walls.size(); ++i) {
    Eigen::Index side = 0;
    (half - samples.points.row(i).transpose().array().abs()).minCoeff(&side);
    EXPECT_NEAR(walls[i], 2 * half[side], 1e-9) << i;
  }
}

TEST(InscribedBall, OfACapsuleHasItsDiameter) {
  const Eigen::VectorXd diameters = at_faces(test::capsule(1, 4, 64, 16), 60);
  EXPECT_NEAR(diameters.minCoeff(), 2, 0.09);  // a centroid is not in the middle of its strip
  EXPECT_LE(diameters.maxCoeff(), 2.002);
}

TEST(InscribedBall, OfAHollowBoxHasTheThicknessOfTheWall) {
  const Shape inner = test::box({3, 3, 3}, 10);
  const Shape shape = test::joined({test::box({4, 4, 4}, 10), test::flipped(inner)});
  const Samples samples = sample_shape(shape, SampleSite::faces);
  const Eigen::VectorXd diameters = inscribed_ball(shape, samples);
  for (Eigen::Index i = 0; i < diameters.size(); ++i) {
    const Eigen::Array3d position = samples.points.row(i).transpose().array().abs();
    const bool over_the_cavity = (position < 1.4).count() == 2;
    if (over_the_cavity) {
      EXPECT_NEAR(diameters[i], 0.5, 1e-9) << i;
    }
  }
}

/// Whether every sample's ball is empty and touches a triangle.
TEST(InscribedBall, ContainsNoSurfacePointAndTouchesOne) {
  const Shape shape = test::torus(2, 0.7, 40, 24);
  const Samples samples = sample_shape(shape, SampleSite::faces);
  const Eigen::VectorXd diameters = inscribed_ball(shape, samples, {.separation_angle_degrees = 0});
  for (Eigen::Index i = 0; i < diameters.size(); i += 7) {
    const double radius = diameters[i] / 2;
    const Eigen::Vector3d centre = (samples.points.row(i) - radius * samples.normals.row(i)).transpose();
    double nearest = 10;
    for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
      if (f == i) continue;
      const auto corner = [&](int k) -> Eigen::Vector3d { return shape.vertices.row(shape.triangles(f, k)); };
      const Triangle triangle{corner(0), corner(1), corner(2)};
      nearest = std::min(nearest, (closest_point(triangle, centre) - centre).norm());
    }
    EXPECT_NEAR(nearest, radius, 1e-6 * radius) << i;
  }
}

TEST(InscribedBall, OfAWedgeHasTheDiameterOfTheTangentCircle) {
  for (const double degrees : {10.0, 30.0, 70.0}) {
    const double slope = std::tan(degrees / 180 * std::numbers::pi);
    Shape wedge = test::box({2, 6, 1}, 40);
    for (auto vertex : wedge.vertices.rowwise()) {
      vertex.x() += 1.001;
      vertex.z() = vertex.z() > 0 ? slope * vertex.x() : 0.0;
    }
    const Samples samples = sample_shape(wedge, SampleSite::faces);
    const Eigen::VectorXd diameters = inscribed_ball(wedge, samples);
    for (Eigen::Index i = 0; i < diameters.size(); ++i) {
      if (samples.normals(i, 2) > -0.9 || samples.points(i, 0) > 0.7 || std::abs(samples.points(i, 1)) > 1.5) continue;
      const double expected = 2 * samples.points(i, 0) * std::tan(degrees / 360 * std::numbers::pi);
      EXPECT_NEAR(diameters[i], expected, 1e-9) << degrees;
    }
  }
}

TEST(InscribedBall, OutsideTheShapeHasTheWidthOfAGap) {
  const Shape lower = test::box({4, 4, 1}, 8);
  Shape upper = lower;
  upper.vertices.col(2).array() += 1.25;
  const Shape shape = test::joined({lower, upper});
  const Samples samples = sample_shape(shape, SampleSite::faces);
  const Eigen::VectorXd gaps = TouchingBalls(shape, {}).diameters(samples, BallSide::outside);
  for (Eigen::Index i = 0; i < gaps.size(); ++i) {
    const bool in_gap = samples.points(i, 2) > 0.49 && samples.points(i, 2) < 0.76;
    if (in_gap) {
      EXPECT_NEAR(gaps[i], 0.25, 1e-9) << i;
    } else {
      EXPECT_TRUE(std::isnan(gaps[i])) << i;
    }
  }
}

TEST(InscribedBall, HardlyShrinksUnderNoise) {
  Shape block = test::box({30, 20, 3}, 30);
  RandomNumbers random(1);
  for (double& coordinate : block.vertices.reshaped()) coordinate += random.uniform(-0.005, 0.005);
  const Samples samples = sample_shape(block, SampleSite::faces);
  const Eigen::VectorXd diameters = inscribed_ball(block, samples);
  EXPECT_GT(diameters.minCoeff(), 2.95);
  for (Eigen::Index i = 0; i < diameters.size(); ++i) {
    if (std::abs(samples.points(i, 2)) > 1.49) {
      EXPECT_NEAR(diameters[i], 3, 0.05) << i;
    }
  }
}

TEST(InscribedBall, MovesAndScalesWithTheShape) {
  const Shape shape = test::torus(2, 0.7, 30, 18);
  const Shape moved = test::transformed(shape, 50, test::rotation(3), {100, -40, 7});
  EXPECT_TRUE(at_faces(moved).isApprox(50 * at_faces(shape), 1e-7));
}

TEST(InscribedBall, DoesNotDependOnTheDistanceFromTheOrigin) {
  for (const double distance : {1e7, 1e8, 1e9}) {
    Shape far = test::torus(2, 0.7, 30, 18);
    far.vertices.array() += distance;
    Shape near = far;
    near.vertices.array() -= distance;
    EXPECT_TRUE(at_faces(far).isApprox(at_faces(near), 1e-5)) << distance;
  }
}

TEST(InscribedBall, IgnoresVerticesWithoutTriangles) {
  Shape shape = test::box({1, 2, 3}, 4);
  const Eigen::VectorXd expected = at_faces(shape);
  shape.vertices.conservativeResize(shape.vertices.rows() + 1, Eigen::NoChange);
  shape.vertices.bottomRows(1) << 1e18, 0, 0;
  EXPECT_EQ(at_faces(shape), expected);
}

TEST(InscribedBall, IsMissingIfItTouchesNoOppositeSurface) {
  const Shape sheet{.vertices = Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = Triangles{{0, 1, 2}}};
  EXPECT_TRUE(std::isnan(at_faces(sheet)[0]));
}

TEST(InscribedBall, OfASphereCloudHasItsDiameterAndNeedsNormals) {
  Shape cloud = test::random_points(test::sphere(1, 4), 4000, 5);
  EXPECT_THROW(inscribed_ball(cloud, sample_shape(cloud, SampleSite::vertices)), InputError);
  cloud.normals = Points::Zero(cloud.vertices.rows(), 3);
  EXPECT_THROW(inscribed_ball(cloud, sample_shape(cloud, SampleSite::vertices)), InputError) << "zero is no normal";
  cloud.normals = cloud.vertices.rowwise().normalized();
  const Eigen::VectorXd diameters = inscribed_ball(cloud, sample_shape(cloud, SampleSite::vertices));
  EXPECT_NEAR(diameters.mean(), 2, 0.05);
}

TEST(InscribedBall, FieldHasTheDiametersOfADirectComputation) {
  const Shape shape = test::sphere(2, 3);
  FieldSettings settings = field_settings("inscribed_ball");
  settings.values.set("separation_angle_degrees", 30.0);
  const Field field = make_field(settings);
  FieldSource source(shape);
  const Samples samples = take_samples(shape, settings.samples);
  EXPECT_EQ(field.compute(source, samples, true).values, at_faces(shape, 30));
  EXPECT_EQ(field.dimension, FieldDimension::length);
  EXPECT_THROW(inscribed_ball(shape, samples, {.separation_angle_degrees = 180}), InputError);
}

}  // namespace
}  // namespace shapegauge

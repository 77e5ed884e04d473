// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

constexpr int draws = 100000;

TEST(GaussianVector, HasMeanZeroAndUnitCovariance) {
  RandomNumbers random(3);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  int beyond_two = 0;
  for (int i = 0; i < draws; ++i) {
    const Eigen::Vector3d x = gaussian_vector(random);
    sum += x;
    squares += x * x.transpose();
    if (std::abs(x[2]) > 2) ++beyond_two;
  }
  // Standard deviations over sqrt(draws): 0.0032 of a mean, 0.0045 of a variance; five of them.
  EXPECT_LT((sum / draws).cwiseAbs().maxCoeff(), 0.016);
  EXPECT_LT((squares / draws - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 0.023);
  EXPECT_NEAR(beyond_two / static_cast<double>(draws), 0.0455, 0.0033);
}

TEST(PointInUnitBall, IsUniformInTheBall) {
  RandomNumbers random(4);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int in_half_radius = 0;
  for (int i = 0; i < draws; ++i) {
    const Eigen::Vector3d x = point_in_unit_ball(random);
    ASSERT_LE(x.norm(), 1);
    sum += x;
    if (x.norm() < 0.5) ++in_half_radius;
  }
  // A coordinate's variance is 1/5; an eighth of the volume is in half the radius.
  EXPECT_LT((sum / draws).cwiseAbs().maxCoeff(), 0.0071);
  EXPECT_NEAR(in_half_radius / static_cast<double>(draws), 0.125, 0.0053);
}

TEST(UniformRotation, IsUniformOverAllRotations) {
  RandomNumbers random(5);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (int i = 0; i < draws; ++i) {
    const Eigen::Matrix3d r = uniform_rotation(random);
    if (i < 100) {
      ASSERT_LT((r * r.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
      ASSERT_NEAR(r.determinant(), 1, 1e-14);
    }
    sum += r;
    squares += r.cwiseProduct(r);
  }
  // Every entry is uniform in [-1, 1]: mean 0, variance 1/3 (of which the variance is 4/45).
  EXPECT_LT((sum / draws).cwiseAbs().maxCoeff(), 0.0092);
  EXPECT_LT((squares / draws - Eigen::Matrix3d::Constant(1. / 3)).cwiseAbs().maxCoeff(), 0.0048);
}

TEST(RandomSelection, SelectsTheRequestedFractionOfElementsToTheNearestInteger) {
  RandomNumbers random(1);
  for (const auto& [count, fraction, expected] : {std::tuple{10, 0.0, 0},
                                                  {10, 1.0, 10},
                                                  {10, 0.24, 2},
                                                  {10, 0.26, 3},
                                                  {7, 0.5, 4},
                                                  {1001, 0.15, 150},
                                                  {0, 0.5, 0}}) {
    EXPECT_EQ(std::ranges::count(random_selection(count, fraction, random), true), expected)
        << count << " " << fraction;
  }
}

TEST(RandomSelection, RejectsFractionsOutOfRange) {
  RandomNumbers random(1);
  for (const double fraction : {-0.1, 1.1, std::nan("")}) {
    EXPECT_THROW(random_selection(10, fraction, random), InputError);
  }
}

TEST(ElementRemoval, KeepsAllVerticesAndTheOrderOfRemainingTriangles) {
  const Shape box = test::box({1, 1, 1}, 1);
  std::vector<bool> removed(12);
  removed[0] = removed[5] = true;
  const Shape rest = without_elements(box, removed);
  ASSERT_EQ(rest.triangles.rows(), 10);
  EXPECT_EQ(rest.triangles.topRows(4), box.triangles.middleRows(1, 4));
  EXPECT_EQ(rest.triangles.bottomRows(6), box.triangles.bottomRows(6));
  EXPECT_EQ(rest.vertices, box.vertices);
}

TEST(ElementRemoval, RemovesNormalsWithTheirPoints) {
  Shape cloud{.vertices = Points::Random(3, 3), .triangles = {}};
  cloud.normals = Points::Random(3, 3);
  const Shape rest = without_elements(cloud, {false, true, false});
  ASSERT_EQ(rest.vertices.rows(), 2);
  EXPECT_EQ(rest.vertices.row(1), cloud.vertices.row(2));
  EXPECT_EQ(rest.normals.row(1), cloud.normals.row(2));
}

TEST(ElementRemoval, RefusesToRemoveAllElements) {
  EXPECT_THROW(without_elements(test::box({1, 1, 1}, 1), std::vector<bool>(12, true)), InputError);
  EXPECT_THROW(without_elements(Shape{}, {}), InputError);
}

Shape noisy(const Shape& shape, const VertexNoiseOptions& options, std::uint64_t seed) {
  RandomNumbers random(seed);
  return vertex_noise(shape, options, random);
}

TEST(VertexNoise, GaussianCoordinatesHaveTheAmplitudeAsStandardDeviation) {
  const Shape sphere = test::sphere(3, 6);
  const double amplitude = 0.02 * bounding_box_diagonal(sphere);
  const Points moves =
      noisy(sphere, {.amplitude = 0.02, .distribution = NoiseDistribution::gaussian}, 1).vertices - sphere.vertices;
  const auto n = static_cast<double>(moves.size());
  // Five standard deviations of the mean and of the variance.
  EXPECT_NEAR(moves.mean(), 0, 5 * amplitude / std::sqrt(n));
  EXPECT_NEAR(moves.squaredNorm() / n / (amplitude * amplitude), 1, 5 * std::sqrt(2 / n));
}

TEST(VertexNoise, UniformDisplacementsFillTheBall) {
  const Shape sphere = test::sphere(3, 6);
  const double radius = 0.02 * bounding_box_diagonal(sphere);
  const VertexNoiseOptions options{.amplitude = 0.02, .distribution = NoiseDistribution::uniform};
  const Points moves = noisy(sphere, options, 1).vertices - sphere.vertices;
  const auto n = static_cast<double>(moves.rows());
  EXPECT_LE(moves.rowwise().norm().maxCoeff(), radius * (1 + 1e-12));
  // The mean of the squared distance from the centre is 3/5, its variance 3/7 - 9/25.
  EXPECT_NEAR(moves.squaredNorm() / n / (radius * radius), 0.6, 5 * std::sqrt((3. / 7 - 9. / 25) / n));
  EXPECT_LT(moves.colwise().mean().norm(), 5 * radius * std::sqrt(0.6 / n));
}

TEST(VertexNoise, DependsOnTheSeedAndIsProportionalToShapeSize) {
  const Shape box = test::box({1, 2, 3}, 4);
  EXPECT_EQ(noisy(box, {}, 7).vertices, noisy(box, {}, 7).vertices);
  EXPECT_NE(noisy(box, {}, 7).vertices, noisy(box, {}, 8).vertices);
  Shape large = box;
  large.vertices *= 1024;
  EXPECT_LT((noisy(large, {}, 7).vertices / 1024 - noisy(box, {}, 7).vertices).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(noisy(box, {}, 7).triangles, box.triangles);
  EXPECT_EQ(noisy(box, {.amplitude = 0}, 7).vertices, box.vertices);
}

TEST(VertexNoise, MovesThePointsOfACloud) {
  const Shape cloud{.vertices = test::sphere(1, 2).vertices, .triangles = {}};
  const Points moves = noisy(cloud, {.amplitude = 0.1}, 1).vertices - cloud.vertices;
  EXPECT_GT(moves.rowwise().norm().minCoeff(), 0);
}

TEST(VertexNoise, RefusesAShapeWithoutExtentAndANegativeOrNonFiniteAmplitude) {
  const Shape point{.vertices = Points::Ones(5, 3), .triangles = {}};
  EXPECT_THROW(noisy(point, {}, 1), InputError);
  EXPECT_THROW(noisy(Shape{}, {}, 1), InputError);
  for (const double amplitude : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(noisy(test::box({1, 1, 1}, 1), {.amplitude = amplitude}, 1), InputError);
  }
}

Shape thinned(const Shape& shape, double fraction, std::uint64_t seed) {
  RandomNumbers random(seed);
  return remove_faces(shape, fraction, random);
}

TEST(RemoveFaces, RemovesTheRoundedFractionOfFaces) {
  const Shape sphere = test::sphere(1, 3);  // 1280 faces
  EXPECT_EQ(thinned(sphere, 0.15, 1).triangles.rows(), 1280 - 192);
  EXPECT_EQ(thinned(sphere, 0, 1).triangles, sphere.triangles);
  EXPECT_EQ(thinned(sphere, 0.15, 1).vertices, sphere.vertices);
  EXPECT_EQ(thinned(sphere, 0.15, 1).triangles, thinned(sphere, 0.15, 1).triangles);
  EXPECT_NE(thinned(sphere, 0.15, 1).triangles, thinned(sphere, 0.15, 2).triangles);
}

TEST(RemoveFaces, RemovesThePointsOfACloud) {
  Shape cloud;
  cloud.vertices = test::sphere(1, 2).vertices;  // 162 points
  EXPECT_EQ(thinned(cloud, 0.5, 1).vertices.rows(), 81);
}

TEST(RemoveFaces, LeavesAtLeastOneFace) {
  EXPECT_THROW(thinned(test::box({1, 1, 1}, 1), 1, 1), InputError);
  EXPECT_THROW(thinned(test::box({1, 1, 1}, 1), -0.5, 1), InputError);
  EXPECT_THROW(thinned(Shape{}, 0, 1), InputError);
}

Shape turned(const Shape& shape, double fraction, std::uint64_t seed) {
  RandomNumbers random(seed);
  return flip_orientation(shape, fraction, random);
}

TEST(FlipOrientation, ReversesExactlyTheRequestedFractionOfFaces) {
  const Shape sphere = test::sphere(1, 3);
  const Points before = sample_shape(sphere, SampleSite::faces).normals;
  for (const auto& [fraction, expected] : {std::pair{0.0, 0}, {0.25, 320}, {1.0, 1280}}) {
    const Points after = sample_shape(turned(sphere, fraction, 1), SampleSite::faces).normals;
    const Eigen::VectorXd cosines = before.cwiseProduct(after).rowwise().sum();
    EXPECT_EQ((cosines.array() < -0.999).count(), expected);
    EXPECT_EQ((cosines.array() > 0.999).count(), 1280 - expected);
  }
  EXPECT_NE(turned(sphere, 0.25, 1).triangles, turned(sphere, 0.25, 2).triangles);
}

TEST(FlipOrientation, ReversesTheNormalsOfACloud) {
  Shape cloud{.vertices = test::sphere(1, 1).vertices, .triangles = {}};
  EXPECT_EQ(turned(cloud, 1, 1).vertices, cloud.vertices);
  cloud.normals = cloud.vertices;
  EXPECT_EQ(turned(cloud, 1, 1).normals, -cloud.vertices);
}

TEST(FlipOrientation, RejectsFractionsOutOfRange) { EXPECT_THROW(turned(test::box({1, 1, 1}, 1), 1.5, 1), InputError); }

Shape punched(const Shape& shape, const PunchHolesOptions& options, std::uint64_t seed) {
  RandomNumbers random(seed);
  return punch_holes(shape, options, random);
}

TEST(PunchHoles, RemovesACapOfTheHoleRadiusFromASphere) {
  const Shape sphere = test::sphere(1, 6);
  const double radius = 0.1 * bounding_box_diagonal(sphere);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const double lost = surface_area(sphere) - surface_area(punched(sphere, {.number = 1, .radius = 0.1}, seed));
    // Within a chord c of a point on a sphere is a cap of area pi c^2; its rim is as ragged as a triangle is long.
    EXPECT_NEAR(lost / (std::numbers::pi * radius * radius), 1, 0.02) << seed;
  }
}

TEST(PunchHoles, RemovesMoreFacesForMoreHolesAndDependsOnTheSeed) {
  const Shape sphere = test::sphere(1, 4);
  EXPECT_EQ(punched(sphere, {.number = 0}, 1).triangles, sphere.triangles);
  const Eigen::Index one = punched(sphere, {.number = 1}, 1).triangles.rows();
  const Eigen::Index five = punched(sphere, {.number = 5}, 1).triangles.rows();
  EXPECT_LT(one, sphere.triangles.rows());
  EXPECT_LT(five, one);
  EXPECT_EQ(punched(sphere, {}, 1).triangles, punched(sphere, {}, 1).triangles);
  const Triangles first = punched(sphere, {}, 1).triangles;
  const Triangles second = punched(sphere, {}, 2).triangles;
  EXPECT_TRUE(first.rows() != second.rows() || first != second);
}

TEST(PunchHoles, RemovesThePointsOfACloudWithinEachHole) {
  const Shape cloud{.vertices = test::sphere(1, 3).vertices, .triangles = {}};
  const Shape rest = punched(cloud, {.number = 3, .radius = 0}, 1);
  EXPECT_EQ(rest.vertices.rows(), cloud.vertices.rows() - 3);
}

TEST(PunchHoles, RefusesOptionsOutOfRangeAndHolesThatRemoveAllFaces) {
  const Shape box = test::box({1, 1, 1}, 2);
  EXPECT_THROW(punched(box, {.number = 1, .radius = 1}, 1), InputError);
  EXPECT_THROW(punched(box, {.number = 1, .radius = 1.5}, 1), InputError);
  EXPECT_THROW(punched(box, {.number = -1}, 1), InputError);
  EXPECT_THROW(punched(box, {.radius = -1}, 1), InputError);
  EXPECT_THROW(punched(Shape{}, {}, 1), InputError);
  const Shape needle{.vertices = Points{{0, 0, 0}, {1, 0, 0}}, .triangles = Triangles{{0, 1, 1}}};
  EXPECT_THROW(punched(needle, {}, 1), InputError);
}

Shape moved(const Shape& shape, double scale, std::uint64_t seed) {
  RandomNumbers random(seed);
  return random_motion(shape, scale, random);
}

TEST(RandomMotion, IsASimilarityWithoutReflection) {
  const Shape corner{.vertices = Points{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, .triangles = {}};
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Shape other = moved(corner, 10, seed);
    Eigen::Matrix3d before;
    Eigen::Matrix3d after;
    for (int k = 0; k < 3; ++k) {
      before.col(k) = (corner.vertices.row(k + 1) - corner.vertices.row(0)).transpose();
      after.col(k) = (other.vertices.row(k + 1) - other.vertices.row(0)).transpose();
    }
    const double factor = std::cbrt(after.determinant() / before.determinant());
    EXPECT_GE(factor, 0.1);
    EXPECT_LE(factor, 10);
    for (Eigen::Index i = 0; i < corner.vertices.rows(); ++i) {
      EXPECT_NEAR((other.vertices.row(i) - other.vertices.row(0)).norm(),
                  factor * (corner.vertices.row(i) - corner.vertices.row(0)).norm(), 1e-12 * factor);
    }
  }
}

TEST(RandomMotion, DrawsScaleFactorsLogUniformly) {
  const Shape box = test::box({1, 1, 1}, 1);
  constexpr int n = 2000;
  double sum = 0;
  double squares = 0;
  for (std::uint64_t seed = 0; seed < n; ++seed) {
    const double logarithm = std::log(surface_area(moved(box, 5, seed)) / 6) / (2 * std::log(5.0));  // in [-1, 1]
    sum += logarithm;
    squares += logarithm * logarithm;
  }
  EXPECT_NEAR(sum / n, 0, 5 * std::sqrt(1. / 3 / n));
  EXPECT_NEAR(squares / n, 1. / 3, 5 * std::sqrt(4. / 45 / n));
}

TEST(RandomMotion, KeepsTheSizeAndTranslatesByAtMostTheDiagonalAtScaleOne) {
  const Shape box = test::box({1, 2, 3}, 1);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Shape other = moved(box, 1, seed);
    EXPECT_NEAR(surface_area(other), surface_area(box), 1e-12);
    EXPECT_LE(other.vertices.colwise().mean().norm(), bounding_box_diagonal(box) * (1 + 1e-12));
    EXPECT_NE(other.vertices, moved(box, 1, seed + 1).vertices);
    EXPECT_EQ(other.vertices, moved(box, 1, seed).vertices);
  }
}

TEST(RandomMotion, RotatesTheNormalsOfACloud) {
  Shape cloud{.vertices = test::sphere(1, 2).vertices, .triangles = {}};
  cloud.normals = cloud.vertices;
  const Shape other = moved(cloud, 3, 1);
  const Eigen::RowVector3d centre = bounding_box(other).center().transpose();
  for (Eigen::Index i = 0; i < cloud.vertices.rows(); ++i) {
    EXPECT_NEAR(other.normals.row(i).norm(), 1, 1e-12);
    EXPECT_GT(other.normals.row(i).dot((other.vertices.row(i) - centre).normalized()), 0.99);
  }
}

TEST(RandomMotion, RefusesAShapeWithoutExtentAndAScaleBelowOne) {
  EXPECT_THROW(moved(Shape{}, 1, 1), InputError);
  for (const double scale : {0.5, -1.0, std::nan("")}) {
    EXPECT_THROW(moved(test::box({1, 1, 1}, 1), scale, 1), InputError);
  }
}

}  // namespace
}  // namespace shapegauge

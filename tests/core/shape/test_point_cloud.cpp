// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <rapidcheck/gtest.h>
#include <utility>
#include <vector>

#include "shapegauge/core/base/decompositions.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

TEST(PointNeighbours, MatchExhaustiveSearch) {
  RandomNumbers random(5);
  Points points(200, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = random.uniform(-1, 1);
  constexpr Eigen::Index k = 7;
  const PointNeighbours found = nearest_neighbours(points, k);
  ASSERT_EQ(found.indices.rows(), 200);
  ASSERT_EQ(found.indices.cols(), k);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    std::vector<std::pair<double, std::int32_t>> all;
    for (Eigen::Index j = 0; j < points.rows(); ++j) {
      if (j != i) all.emplace_back((points.row(j) - points.row(i)).norm(), static_cast<std::int32_t>(j));
    }
    std::ranges::sort(all);
    for (Eigen::Index m = 0; m < k; ++m) {
      EXPECT_EQ(found.indices(i, m), all[static_cast<std::size_t>(m)].second);
      EXPECT_DOUBLE_EQ(found.distances(i, m), all[static_cast<std::size_t>(m)].first);
    }
  }
}

TEST(PointNeighbours, IncludeCoincidentPoints) {
  Points points = Points::Zero(100, 3);
  points.row(99) << 3, 4, 0;
  const PointNeighbours found = nearest_neighbours(points, 4);
  for (Eigen::Index i = 0; i < 100; ++i) {
    EXPECT_EQ(found.distances.row(i), Eigen::RowVector4d::Constant(i == 99 ? 5 : 0));
    for (const std::int32_t j : found.indices.row(i)) EXPECT_NE(j, i);
  }
}

TEST(PointNeighbours, AreAllOtherPointsIfMoreAreRequested) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {5, 0, 0}};
  const PointNeighbours found = nearest_neighbours(points, 8);
  EXPECT_EQ(found.indices.cols(), 2);
  EXPECT_EQ(found.distances, (Eigen::Matrix<double, 3, 2>() << 1, 5, 1, 4, 4, 5).finished());
  EXPECT_EQ(nearest_neighbours(points.topRows(1), 8).indices.cols(), 0);
  EXPECT_EQ(nearest_neighbours(Points(0, 3), 8).indices.rows(), 0);
}

TEST(NearestPoints, MatchExhaustiveSearch) {
  const Points points = Points::Random(300, 3);
  const Points among = Points::Random(80, 3);
  const std::vector<std::int32_t> found = nearest_points(points, among);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Eigen::Index nearest = 0;
    (among.rowwise() - points.row(i)).rowwise().squaredNorm().minCoeff(&nearest);
    EXPECT_EQ(found[static_cast<std::size_t>(i)], nearest);
  }
  EXPECT_EQ(nearest_points(points, points.topRows(1)), std::vector<std::int32_t>(300, 0));
}

Points random_points_of_sphere() { return test::random_points(test::sphere(1, 5), 5000, 1).vertices; }

TEST(PointNormals, ArePerpendicularToAPlaneAtAnyScale) {
  const Eigen::Matrix3d turn = test::rotation(4);
  for (const double scale : {1e-30, 1.0, 1e30}) {
    Points points = Points::Random(500, 3);
    points.col(2).setZero();
    points = (scale * points * turn.transpose()).eval();
    const Points normals = unsigned_point_normals(points);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      EXPECT_NEAR(std::abs(normals.row(i).dot(turn.col(2))), 1, 1e-6) << i;
      EXPECT_NEAR(normals.row(i).norm(), 1, 1e-12);
    }
  }
}

TEST(PointNormals, OfASphereAreRadial) {
  const Points points = random_points_of_sphere();
  const Points normals = unsigned_point_normals(points);
  double sum = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double cosine = std::abs(normals.row(i).dot(points.row(i).normalized()));
    EXPECT_GT(cosine, std::cos(0.5)) << i;
    sum += cosine;
  }
  EXPECT_GT(sum / static_cast<double>(points.rows()), std::cos(0.05));  // 3 degrees; the neighbours are within 0.1
}

/// Directions of least variance of each point and its 12 nearest neighbours.
Points normals_of_min_variance(const Points& points) {
  const PointNeighbours nearest = nearest_neighbours(points, 12);
  Points normals(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Eigen::MatrixX3d around(13, 3);
    around << points.row(i), points(nearest.indices.row(i), Eigen::all);
    around.rowwise() -= around.colwise().mean().eval();
    const auto solver = eigen_decomposition(Eigen::Matrix3d(around.transpose() * around));
    normals.row(i) = solver.eigenvectors().col(0).transpose();
  }
  return normals;
}

/// Number of normals more than 20 degrees off.
Eigen::Index count_wrong(const Points& normals, const Points& expected) {
  const Eigen::ArrayXd cosines = (normals.array() * expected.array()).rowwise().sum().abs();
  return (cosines < std::cos(20 * std::numbers::pi / 180)).count();
}

TEST(PointNormals, OfTouchingBallsAreRadial) {
  // Two unit balls touch at the origin. Near it, most neighbours of a point belong to both.
  const Points ball = test::random_points(test::sphere(1, 5), 20'000, 1).vertices;
  std::vector<Eigen::Index> near_contact;
  for (Eigen::Index i = 0; i < ball.rows(); ++i) {
    if (ball(i, 0) < -0.98) near_contact.push_back(i);
  }
  const auto count = static_cast<Eigen::Index>(near_contact.size());
  Points points(2 * count, 3);
  Points radial(2 * count, 3);
  radial.topRows(count) = ball(near_contact, Eigen::all).rowwise().normalized();
  points.topRows(count) = ball(near_contact, Eigen::all).rowwise() + Eigen::RowVector3d(1, 0, 0);
  const Eigen::DiagonalMatrix<double, 3> mirrored(-1, 1, 1);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()).toRotationMatrix();
  points.bottomRows(count) = points.topRows(count) * turn * mirrored;
  radial.bottomRows(count) = radial.topRows(count) * turn * mirrored;
  const Eigen::Index by_variance = count_wrong(normals_of_min_variance(points), radial);
  EXPECT_LT(3 * count_wrong(unsigned_point_normals(points), radial), by_variance);
}

TEST(PointNormals, HaveFewerErrorsAtBoxEdgesThanNormalsOfLeastVariance) {
  const Shape box = test::box({1, 1, 1}, 1);
  const Points points = test::random_points(box, 3000, 1).vertices;
  Points sides = Points::Zero(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Eigen::Index axis = 0;
    points.row(i).cwiseAbs().maxCoeff(&axis);
    sides(i, axis) = 1;
  }
  const Eigen::Index by_variance = count_wrong(normals_of_min_variance(points), sides);
  EXPECT_LT(3 * count_wrong(unsigned_point_normals(points), sides), by_variance);
}

TEST(PointNormals, OfPointsOnALineArePerpendicularToIt) {
  const Eigen::RowVector3d along = Eigen::RowVector3d(1, 2, 3).normalized();
  Points points(50, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) points.row(i) = static_cast<double>(i) * along;
  const Points normals = unsigned_point_normals(points);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    EXPECT_NEAR(normals.row(i).norm(), 1, 1e-12);
    EXPECT_NEAR(normals.row(i).dot(along), 0, 1e-6);
  }
}

TEST(PointNormals, OfCoincidentPointsAreZero) {
  EXPECT_TRUE(unsigned_point_normals(Points::Constant(20, 3, 5)).isZero(0));
  EXPECT_TRUE(unsigned_point_normals(Points::Zero(1, 3)).isZero(0));
  // Thirteen coincident points: all twelve nearest neighbours are at distance 0.
  Points points = random_points_of_sphere();
  points.topRows(13).rowwise() = points.row(0).eval();
  const Points normals = unsigned_point_normals(points);
  EXPECT_TRUE(normals.topRows(13).isZero(0));
  for (Eigen::Index i = 13; i < points.rows(); ++i) EXPECT_NEAR(normals.row(i).norm(), 1, 1e-12);
}

using test::random_points;

/// Relative error of the weights' sum as an estimate of the mesh's area.
double bias(const Shape& mesh, Eigen::Index points) {
  return point_weights(random_points(mesh, points, 1).vertices).sum() / surface_area(mesh) - 1;
}

/// Points far apart, with independent weights.
Points scattered(unsigned seed, Eigen::Index count) {
  return random_points(test::torus(2, 0.5, 30, 60), count, seed).vertices;
}

TEST(PointWeights, SumToTheSurfaceArea) {
  // The relative standard deviation of a weight is about 1/sqrt(8), that of the sum of 10,000, which overlap, 1 %.
  EXPECT_NEAR(bias(test::sphere(3, 5), 10'000), 0, 0.03);
  EXPECT_NEAR(bias(test::torus(2, 0.4, 40, 120), 10'000), 0, 0.03);
  EXPECT_NEAR(bias(test::capsule(0.3, 5, 40, 10), 10'000), 0, 0.03);
  EXPECT_NEAR(bias(test::box({1, 2, 3}, 1), 10'000), 0, 0.03);
}

TEST(PointWeights, AreInverselyProportionalToTheDensity) {
  // Equally many points on both spheres.
  Shape small = random_points(test::sphere(1, 4), 4000, 1);
  small.vertices.col(0).array() += 20;
  const Shape large = random_points(test::sphere(10, 4), 4000, 2);
  Points both(8000, 3);
  both << small.vertices, large.vertices;
  const Eigen::VectorXd weights = point_weights(both);
  EXPECT_NEAR(weights.head(4000).sum() / (4 * std::numbers::pi), 1, 0.04);
  EXPECT_NEAR(weights.tail(4000).sum() / (400 * std::numbers::pi), 1, 0.04);
}

TEST(PointWeights, OverestimateTheAreaOfARegularGridByATenth) {
  // The disc to the k-th neighbour holds k + 1/2 points of a grid on the average, instead of k.
  const Shape mesh = test::sphere(1, 5);
  const double ratio = point_weights(mesh.vertices).sum() / surface_area(mesh);
  EXPECT_GT(ratio, 1);
  EXPECT_LT(ratio, 1.13);
}

RC_GTEST_PROP(PointWeights, ArePermutedWithThePoints, (unsigned seed)) {
  Points points = scattered(seed, 60);
  points.bottomRows(5) = points.topRows(5);  // coincident
  const Shape cloud{points, {}, {}};
  const test::Permuted permuted = test::permuted(cloud, seed);
  const Eigen::VectorXd before = point_weights(points);
  const Eigen::VectorXd after = point_weights(permuted.shape.vertices);
  for (std::size_t i = 0; i < permuted.vertices.size(); ++i) {
    RC_ASSERT(after[static_cast<Eigen::Index>(i)] == before[permuted.vertices[i]]);
  }
}

RC_GTEST_PROP(PointWeights, ScaleAndMoveWithTheShape, (unsigned seed)) {
  const Shape cloud{scattered(seed, 60), {}, {}};
  const double scale = std::pow(10, *rc::gen::inRange(-30, 31));
  const Shape moved = test::transformed(cloud, scale, test::rotation(seed), scale * Eigen::Vector3d(3, -2, 5));
  const Eigen::VectorXd before = point_weights(cloud.vertices);
  RC_ASSERT(before.minCoeff() > 0);
  RC_ASSERT((point_weights(moved.vertices) / scale / scale).isApprox(before, 1e-9));
}

TEST(PointWeights, DuplicatesShareTheWeightOfOnePoint) {
  const Points single = scattered(1, 300);
  Points all(300 + 20 + 1, 3);
  all << single, single.row(7).replicate(20, 1), single.row(9);
  const Eigen::VectorXd expected = point_weights(single);
  const Eigen::VectorXd weights = point_weights(all);
  EXPECT_NEAR(weights.sum(), expected.sum(), 1e-12 * expected.sum());
  EXPECT_DOUBLE_EQ(weights[7], expected[7] / 21);
  EXPECT_DOUBLE_EQ(weights[310], expected[7] / 21);
  EXPECT_DOUBLE_EQ(weights[320], expected[9] / 2);
  EXPECT_DOUBLE_EQ(weights[8], expected[8]);
}

TEST(PointWeights, LimitTheWeightOfAnOutlier) {
  const Points cluster = scattered(1, 2000);
  const Eigen::VectorXd alone = point_weights(cluster);
  for (const double distance : {10.0, 1e3, 1e9}) {
    Points points(2002, 3);
    points << cluster, distance, 0, 0, -distance, distance, 0;
    const Eigen::VectorXd weights = point_weights(points);
    // The cap is 4 times the median of the neighbours' weights, none of which exceeds 4 times the mean.
    EXPECT_LT(weights.tail(2).maxCoeff(), 16 * alone.mean()) << distance;
    EXPECT_GT(weights.tail(2).minCoeff(), 0);
    if (distance < 1e6) {
      EXPECT_TRUE(weights.head(2000).isApprox(alone, 1e-6)) << distance;
    }
  }
}

TEST(PointWeights, MaximumOnARandomSurfaceCloudIsTwoToFourTimesTheMean) {
  const Points points = scattered(1, 5000);
  const Eigen::VectorXd weights = point_weights(points);
  // Without the cap, a weight is distributed much as Gamma(8)/8 in units of the mean: above 3.5 once in 100,000 points.
  EXPECT_LT(weights.maxCoeff() / weights.mean(), 4);
  EXPECT_GT(weights.maxCoeff() / weights.mean(), 2);
}

TEST(PointWeights, AreZeroForCoincidentPointsAndDiscAreasForTwoPoints) {
  EXPECT_EQ(point_weights(Points(0, 3)).size(), 0);
  EXPECT_EQ(point_weights(Points::Ones(1, 3)), Eigen::VectorXd::Zero(1));
  EXPECT_EQ(point_weights(Points::Ones(50, 3)), Eigen::VectorXd::Zero(50));
  const Points two{{0, 0, 0}, {2, 0, 0}};
  EXPECT_TRUE(point_weights(two).isApprox(Eigen::Vector2d::Constant(4 * std::numbers::pi), 1e-14));
}

TEST(PointWeights, MatchTheFormulaOnALineAndArePositiveInAPlane) {
  Points line = Points::Zero(100, 3);
  line.col(1).setLinSpaced(100, 0, 99);
  // Away from the ends the neighbours 5 to 12 are 3, 3, 4, 4, 5, 5, 6 and 6 away.
  const double mean = (9. / 5 + 9. / 6 + 16. / 7 + 16. / 8 + 25. / 9 + 25. / 10 + 36. / 11 + 36. / 12) / 8;
  EXPECT_NEAR(point_weights(line)[50], std::numbers::pi * mean, 1e-11);
  Points plane = scattered(1, 100);
  plane.col(2).setConstant(7);
  EXPECT_GT(point_weights(plane).minCoeff(), 0);
}

TEST(PointWeights, RejectNonFinitePoints) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Points points = scattered(1, 20);
    points(3, 1) = bad;
    EXPECT_THROW(point_weights(points), InputError);
  }
  Points too_large = scattered(1, 20);
  too_large(0, 0) = -1.7e308;
  too_large(1, 0) = 1.7e308;
  EXPECT_THROW(point_weights(too_large), InputError);
}

}  // namespace

}  // namespace shapegauge

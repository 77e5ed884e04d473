// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/proxy/dense_samples.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "tests/core/proxy/proxy_shapes.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

DenseSamples dense(const Shape& shape, Eigen::Index count) {
  return dense_samples(shape, half_edges(shape.triangles, welded_vertices(shape.vertices)), count);
}

Eigen::RowVector3d corner_of(const Shape& mesh, std::int32_t triangle, int k) {
  return mesh.vertices.row(mesh.triangles(triangle, k));
}

/// Cross product of two sides: twice the area, along the normal.
Eigen::RowVector3d cross_of(const Shape& mesh, std::int32_t triangle) {
  const Eigen::RowVector3d a = corner_of(mesh, triangle, 0);
  return (corner_of(mesh, triangle, 1) - a).cross(corner_of(mesh, triangle, 2) - a);
}

/// Barycentric coordinates of the projection of a point onto a triangle's plane.
Eigen::Vector3d barycentric(const Shape& mesh, std::int32_t triangle, const Eigen::RowVector3d& x) {
  const Eigen::RowVector3d cross = cross_of(mesh, triangle);
  Eigen::Vector3d result;
  for (int k = 0; k < 3; ++k) {
    const Eigen::RowVector3d b = corner_of(mesh, triangle, (k + 1) % 3);
    const Eigen::RowVector3d c = corner_of(mesh, triangle, (k + 2) % 3);
    result[k] = (b - x).cross(c - x).dot(cross) / cross.squaredNorm();
  }
  return result;
}

/// A mesh with triangles of very different sizes.
Shape uneven_mesh() { return test::joined({test::torus(2, 0.5, 9, 5), test::box({1, 0.2, 0.1}, 3)}); }

TEST(DenseSamples, LieOnTheirTrianglesAndHaveTheTriangleNormals) {
  const Shape mesh = uneven_mesh();
  const DenseSamples samples = dense(mesh, 2000);
  ASSERT_EQ(samples.points.rows(), 2000);
  ASSERT_EQ(samples.triangles.size(), 2000U);
  for (Eigen::Index i = 0; i < 2000; ++i) {
    const std::int32_t triangle = samples.triangles[static_cast<std::size_t>(i)];
    const Eigen::RowVector3d normal = cross_of(mesh, triangle).normalized();
    const Eigen::RowVector3d point = samples.points.row(i);
    EXPECT_NEAR((point - corner_of(mesh, triangle, 0)).dot(normal), 0, 1e-12);
    EXPECT_GT(barycentric(mesh, triangle, point).minCoeff(), -1e-12);
    EXPECT_NEAR(std::abs(samples.normals.row(i).dot(normal)), 1, 1e-12);
    EXPECT_NEAR(samples.normals.row(i).norm(), 1, 1e-12);
  }
}

TEST(DenseSamples, AreStratifiedByArea) {
  const Shape mesh = uneven_mesh();
  const double total = surface_area(mesh);
  for (const Eigen::Index count : {1, 7, 100, 3000}) {
    const DenseSamples samples = dense(mesh, count);
    EXPECT_NEAR(samples.areas.sum(), total, 1e-9 * total);
    EXPECT_EQ(samples.areas.minCoeff(), samples.areas.maxCoeff());
    std::map<std::int32_t, double> of_triangle;
    for (const std::int32_t triangle : samples.triangles) ++of_triangle[triangle];
    for (std::int32_t f = 0; f < mesh.triangles.rows(); ++f) {
      const double expected = static_cast<double>(count) * cross_of(mesh, f).norm() / 2 / total;
      EXPECT_LT(std::abs(of_triangle[f] - expected), 1 + 1e-9) << "triangle " << f << " of " << count;
    }
    // Those of a triangle are consecutive.
    std::vector<std::int32_t> runs = samples.triangles;
    runs.erase(std::unique(runs.begin(), runs.end()), runs.end());
    EXPECT_EQ(std::set(runs.begin(), runs.end()).size(), runs.size());
  }
}

TEST(DenseSamples, SpreadEvenlyInATriangle) {
  const Shape triangle{Points{{1, 0, 3}, {5, 1, 3}, {2, 4, 2}}, Triangles{{0, 1, 2}}};
  constexpr int count = 1600;
  const DenseSamples samples = dense(triangle, count);
  // Halves of the cells of a 4 x 4 grid in barycentric coordinates: 16 triangles of equal area.
  std::map<std::tuple<int, int, int>, int> found;
  for (const auto& point : samples.points.rowwise()) {
    const Eigen::Array3d scaled = 4 * barycentric(triangle, 0, point).array();
    ++found[{static_cast<int>(scaled[0]), static_cast<int>(scaled[1]), static_cast<int>(scaled[2])}];
  }
  ASSERT_EQ(found.size(), 16U);
  double chi_squared = 0;
  for (const auto& [cell, number] : found) chi_squared += std::pow(number - count / 16.0, 2) / (count / 16.0);
  EXPECT_LT(chi_squared, 15) << "the expectation for random points";
}

/// Checks that two meshes with the same surface have the same samples; `triangles` maps those of `b` to those of `a`.
void expect_same_samples(const Shape& a, const Shape& b, const std::vector<std::int32_t>& triangles) {
  const DenseSamples of_a = dense(a, 500);
  const DenseSamples of_b = dense(b, 500);
  EXPECT_EQ(of_a.points, of_b.points);
  EXPECT_EQ(of_a.areas, of_b.areas);
  for (Eigen::Index i = 0; i < 500; ++i) {
    const auto index = static_cast<std::size_t>(i);
    EXPECT_EQ(of_a.triangles[index], triangles[static_cast<std::size_t>(of_b.triangles[index])]);
    EXPECT_EQ(of_a.normals.row(i).cwiseAbs(), of_b.normals.row(i).cwiseAbs());
    const auto first = static_cast<std::int32_t>(0);
    const auto sample = static_cast<std::int32_t>(i);
    EXPECT_EQ(of_a.sheets[index] == of_a.sheets[0], of_b.sheets[index] == of_b.sheets[0]);
    EXPECT_EQ(normal_agreement(of_a, first, sample), normal_agreement(of_b, first, sample));
  }
}

TEST(DenseSamples, DoNotDependOnTheOrderAndOrientationOfTriangles) {
  const Shape mesh = uneven_mesh();
  std::vector<std::int32_t> same(static_cast<std::size_t>(mesh.triangles.rows()));
  for (std::size_t f = 0; f < same.size(); ++f) same[f] = static_cast<std::int32_t>(f);
  expect_same_samples(mesh, test::flipped(mesh), same);
  expect_same_samples(mesh, test::half_flipped(mesh, 1), same);
  expect_same_samples(mesh, test::soup(mesh), same);
  for (const unsigned seed : {1U, 2U, 3U}) {
    const test::Permuted other = test::permuted(mesh, seed);
    expect_same_samples(mesh, other.shape, other.triangles);
  }
}

TEST(DenseSamples, CountDuplicateTrianglesOnceAndIgnoreDegenerateOnes) {
  const Shape mesh = test::torus(2, 0.5, 9, 5);
  Shape more = test::joined({mesh, test::flipped(mesh)});
  more.triangles.conservativeResize(more.triangles.rows() + 2, 3);
  more.triangles.bottomRows(2) << 0, 0, 1, 3, 3, 3;
  const DenseSamples expected = dense(mesh, 400);
  const DenseSamples found = dense(more, 400);
  EXPECT_EQ(found.points, expected.points);
  EXPECT_EQ(found.areas, expected.areas);
  EXPECT_EQ(found.triangles, expected.triangles);
  const Shape flat{Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, Triangles{{0, 1, 2}, {0, 1, 3}}};
  const std::vector<std::int32_t> chosen = dense(flat, 20).triangles;
  EXPECT_EQ(std::ranges::count(chosen, 1), 20) << "corners on a line";
}

TEST(DenseSamples, OrientNormalsConsistentlyWithinASheet) {
  const Shape two = test::joined(
      {test::sphere(1, 2), test::transformed(test::sphere(0.5, 2), 1, Eigen::Matrix3d::Identity(), {4, 0, 0})});
  const DenseSamples samples = dense(test::half_flipped(two, 2), 1000);
  std::map<bool, std::set<std::int32_t>> sheets;
  std::map<bool, std::set<bool>> outward;
  for (Eigen::Index i = 0; i < 1000; ++i) {
    const bool right = samples.points(i, 0) > 2;
    sheets[right].insert(samples.sheets[static_cast<std::size_t>(i)]);
    const Eigen::RowVector3d from_centre = samples.points.row(i) - Eigen::RowVector3d(right ? 4 : 0, 0, 0);
    outward[right].insert(samples.normals.row(i).dot(from_centre) > 0);
  }
  for (const bool right : {false, true}) {
    EXPECT_EQ(sheets[right].size(), 1U);
    EXPECT_EQ(outward[right].size(), 1U);
    EXPECT_GE(*sheets[right].begin(), 0);
  }
  EXPECT_NE(sheets[false], sheets[true]);
}

TEST(DenseSamples, DoNotOrientAMoebiusBand) {
  for (const int half_turns : {0, 1, 2, 3}) {
    const DenseSamples samples = dense(test::twisted_band(24, half_turns), 300);
    const std::set<std::int32_t> sheets(samples.sheets.begin(), samples.sheets.end());
    ASSERT_EQ(sheets.size(), 1U) << half_turns;
    EXPECT_EQ(*sheets.begin() == -1, half_turns % 2 == 1) << half_turns;
  }
}

TEST(DenseSamples, BelongToDifferentSheetsAcrossANonManifoldEdge) {
  // A square of two triangles, and a third triangle at its diagonal.
  const Shape fins{Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}},
                   Triangles{{0, 1, 2}, {0, 2, 3}, {0, 2, 4}}};
  const DenseSamples samples = dense(fins, 300);
  std::map<std::int32_t, std::set<std::int32_t>> of_triangle;
  for (std::size_t i = 0; i < 300; ++i) of_triangle[samples.triangles[i]].insert(samples.sheets[i]);
  std::set<std::int32_t> all;
  for (const auto& [triangle, sheets] : of_triangle) all.insert(sheets.begin(), sheets.end());
  EXPECT_EQ(all.size(), 3U);
}

TEST(DenseSamples, RejectShapesWithoutArea) {
  EXPECT_THROW(dense(test::box({0, 0, 1}, 1), 10), InputError);
  EXPECT_THROW(dense({Points::Ones(5, 3), {}, {}}, 10), InputError);
}

std::set<std::tuple<double, double, double>> positions_of(const Points& points) {
  std::set<std::tuple<double, double, double>> positions;
  for (const auto& row : points.rowwise()) positions.emplace(row[0], row[1], row[2]);
  return positions;
}

/// 300 points on a sphere, 40 of them twice.
Shape repetitive_cloud() {
  Shape cloud = test::random_points(test::sphere(1, 4), 300, 1);
  cloud.vertices.conservativeResize(340, 3);
  cloud.vertices.bottomRows(40) = cloud.vertices.topRows(40);
  return cloud;
}

TEST(DenseSamples, OfACloudAreItsDistinctPoints) {
  const Shape cloud = repetitive_cloud();
  const DenseSamples samples = dense(cloud, 1000);
  ASSERT_EQ(samples.points.rows(), 300);
  EXPECT_EQ(positions_of(samples.points), positions_of(cloud.vertices));
  EXPECT_TRUE(samples.triangles.empty());
  EXPECT_EQ(std::ranges::count(samples.sheets, -1), 300);
  EXPECT_EQ(samples.areas, point_weights(samples.points));
  EXPECT_EQ(samples.normals, unsigned_point_normals(samples.points));
}

TEST(DenseSamples, DoNotDependOnTheOrderOfPoints) {
  const Shape cloud = repetitive_cloud();
  Shape reversed = cloud;
  reversed.vertices = cloud.vertices.colwise().reverse().eval();
  for (const Eigen::Index count : {120, 1000}) {
    EXPECT_EQ(dense(cloud, count).points, dense(reversed, count).points);
    EXPECT_EQ(dense(cloud, count).areas, dense(reversed, count).areas);
  }
}

TEST(DenseSamples, OfALargeCloudAreEveryNthPointAlongTheMortonCurve) {
  const Shape cloud = repetitive_cloud();
  const Points all = dense(cloud, 1000).points;
  for (const Eigen::Index count : {2, 7, 120, 299}) {
    const Points some = dense(cloud, count).points;
    ASSERT_EQ(some.rows(), count);
    std::vector<Eigen::Index> ranks;
    for (const auto& point : some.rowwise()) {
      Eigen::Index rank = -1;
      EXPECT_EQ((all.rowwise() - point).rowwise().squaredNorm().minCoeff(&rank), 0);
      ranks.push_back(rank);
    }
    const double spacing = 300.0 / static_cast<double>(count);
    for (std::size_t i = 0; i < ranks.size(); ++i) {
      // The middle of the i-th of equal parts, rounded down.
      EXPECT_NEAR(static_cast<double>(ranks[i]), (static_cast<double>(i) + 0.5) * spacing - 0.5, 0.5);
    }
  }
}

/// Two samples with these normals in these sheets.
DenseSamples two_samples(const Eigen::RowVector3d& position, const Eigen::RowVector3d& first,
                         const Eigen::RowVector3d& second, std::int32_t sheet_of_second = 0) {
  return {Points{{0, 0, 0}, {position.x(), position.y(), position.z()}},
          Points{{first.x(), first.y(), first.z()}, {second.x(), second.y(), second.z()}},
          Eigen::VectorXd::Ones(2),
          {0, sheet_of_second},
          {}};
}

bool are_on_same_sheet(const DenseSamples& samples) {
  const bool same = on_same_sheet(samples, 0, 1, (samples.points.row(1) - samples.points.row(0)).norm());
  EXPECT_EQ(on_same_sheet(samples, 1, 0, (samples.points.row(1) - samples.points.row(0)).norm()), same);
  return same;
}

TEST(NormalAgreement, IgnoresTheSignOfNormalsOfDifferentSheets) {
  const Eigen::RowVector3d down(0.6, 0, -0.8);
  EXPECT_DOUBLE_EQ(normal_agreement(two_samples({1, 0, 0}, {0, 0, 1}, down, 0), 0, 1), -0.8);
  EXPECT_DOUBLE_EQ(normal_agreement(two_samples({1, 0, 0}, {0, 0, 1}, down, 1), 0, 1), 0.8);
  DenseSamples of_no_sheet = two_samples({1, 0, 0}, {0, 0, 1}, down, -1);
  of_no_sheet.sheets[0] = -1;
  EXPECT_DOUBLE_EQ(normal_agreement(of_no_sheet, 0, 1), 0.8);
}

TEST(OnSameSheet, HoldsForTwoPointsOnAnArcShorterThan107Degrees) {
  for (int degrees = 1; degrees < 180; degrees += 2) {
    const double turn = degrees * std::numbers::pi / 180;
    const Eigen::RowVector3d position(std::sin(turn), 0, std::cos(turn) - 1);
    const Eigen::RowVector3d normal(std::sin(turn), 0, std::cos(turn));
    for (const double sign : {1.0, -1.0}) {  // seen from either side
      EXPECT_EQ(are_on_same_sheet(two_samples(position, {0, 0, sign}, sign * normal)), degrees < 107.46) << degrees;
    }
  }
}

TEST(OnSameSheet, ExcludesTheOtherSideOfAThinWall) {
  for (const std::int32_t sheet : {0, 1}) {
    EXPECT_FALSE(are_on_same_sheet(two_samples({0.1, 0, -0.3}, {0, 0, 1}, {0, 0, -1}, sheet))) << sheet;
  }
  EXPECT_FALSE(are_on_same_sheet(two_samples({1, 0, 0}, {0, 0, 1}, {0, 0, -1}))) << "around the rim, by the normals";
  EXPECT_TRUE(are_on_same_sheet(two_samples({1, 0, 0}, {0, 0, 1}, {0, 0, -1}, 1))) << "turned triangles";
}

TEST(OnSameSheet, HoldsForParallelNormalsOnlyIfTheConnectionIsNearlyTangential) {
  // Both distances from the planes are sin(a), and their squares are below 0.2 together.
  const double limit = std::asin(std::sqrt(0.1));
  for (const double angle : {0.0, 0.9 * limit, 1.1 * limit, 1.5}) {
    const Eigen::RowVector3d position(std::cos(angle), 0, std::sin(angle));
    EXPECT_EQ(are_on_same_sheet(two_samples(position, {0, 0, 1}, {0, 0, 1})), angle < limit) << angle;
    EXPECT_EQ(are_on_same_sheet(two_samples(7 * position, {0, 0, 1}, {0, 0, 1})), angle < limit) << "at any distance";
  }
}

}  // namespace
}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <set>
#include <vector>

#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/pages/coarse_view.h"
#include "tests/pages/sample_views.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

TEST(CoarseShape, KeepsAreaAndVolumeWithFewFaces) {
  for (const Eigen::Index faces : {200, 800}) {
    const Shape torus = test::torus(1, 0.3, 200, 80);
    const Shape coarse = coarse_shape(torus, faces);
    EXPECT_LE(coarse.triangles.rows(), faces);
    EXPECT_GE(coarse.triangles.rows(), faces / 2);
    EXPECT_NEAR(surface_area(coarse), surface_area(torus), 0.1 * surface_area(torus));
    // An inscribed torus of 20 by 5 quads has 24 % less volume than the round one, and four times the faces a quarter
    // of that.
    EXPECT_NEAR(test::signed_volume(coarse) / test::signed_volume(torus), 1, 50.0 / static_cast<double>(faces));
  }
}

TEST(CoarseShape, SimplifiesTriangleSoups) {
  const Shape soup = test::soup(test::sphere(1, 5));
  const Shape coarse = coarse_shape(soup, 300);
  EXPECT_LE(coarse.triangles.rows(), 300);
  EXPECT_GE(coarse.triangles.rows(), 100);
  EXPECT_NEAR(surface_area(coarse), surface_area(soup), 0.15 * surface_area(soup));
}

/// Triangles that have nothing to do with each other, which no edge collapse makes fewer.
TEST(CoarseShape, OfUnconnectedTrianglesHasAtMostTheRequestedFaces) {
  Shape scattered{.vertices = 10 * Points::Random(3000, 3), .triangles = Triangles(1000, 3)};
  for (std::int32_t f = 0; f < 1000; ++f) scattered.triangles.row(f) << 3 * f, 3 * f + 1, 3 * f + 2;
  const Shape coarse = coarse_shape(scattered, 200);
  EXPECT_LE(coarse.triangles.rows(), 200);
  EXPECT_GE(coarse.triangles.rows(), 50);
}

/// Needles, each in one column of any grid: merging their vertices leaves none.
TEST(CoarseShape, KeepsTheLargestFacesIfVertexClusteringLeavesNone) {
  constexpr std::int32_t count = 1000;
  Shape needles{.vertices = Points(3 * count, 3), .triangles = Triangles(count, 3)};
  for (std::int32_t f = 0; f < count; ++f) {
    needles.vertices.row(3 * f) << 0.1 * f, 0, 0;
    needles.vertices.row(3 * f + 1) << 0.1 * f + 1e-3, 0, 0;
    needles.vertices.row(3 * f + 2) << 0.1 * f, 1e-3 + 1e-6 * f, 0;
    needles.triangles.row(f) << 3 * f, 3 * f + 1, 3 * f + 2;
  }
  const Shape coarse = coarse_shape(needles, 200);
  EXPECT_EQ(coarse.triangles.rows(), 200);
  EXPECT_GT(surface_area(coarse), 0.2 * surface_area(needles));
  EXPECT_TRUE(std::ranges::is_sorted(coarse.triangles.col(0)));
}

TEST(CoarseShape, DoesNotChangeAShapeWithinTheFaceLimit) {
  const Shape sphere = test::sphere(1, 2);
  EXPECT_EQ(coarse_shape(sphere, sphere.triangles.rows()).triangles, sphere.triangles);
}

TEST(CoarseShape, KeepsASubsetOfThePointsOfACloud) {
  const Shape cloud = test::random_points(test::sphere(1, 4), 2000, 1);
  const Shape coarse = coarse_shape(cloud, 300);
  ASSERT_EQ(coarse.vertices.rows(), 300);
  std::set<std::vector<double>> points;
  for (const auto& point : cloud.vertices.rowwise()) points.insert({point[0], point[1], point[2]});
  for (const auto& point : coarse.vertices.rowwise()) EXPECT_TRUE(points.contains({point[0], point[1], point[2]}));
}

TEST(ResampledValues, KeepConstantsAndHardlyChangeALinearField) {
  const Shape fine = test::sphere(1, 5);
  const Samples from = sample_shape(fine, SampleSite::faces);
  const Samples to = sample_shape(coarse_shape(fine, 500), SampleSite::vertices);
  const ValueTransfer carried(from, to);
  const Eigen::VectorXd constant = carried.means(Eigen::VectorXd::Constant(from.points.rows(), 0.7));
  EXPECT_NEAR((constant.array() - 0.7).abs().maxCoeff(), 0, 1e-12);
  // Faces of about 0.16: means are over points within about that distance.
  EXPECT_LT((carried.means(from.points.col(0)) - to.points.col(0)).cwiseAbs().maxCoeff(), 0.12);
  const Points directions = carried.directions(from.normals);
  EXPECT_GT((directions.array() * to.points.array()).rowwise().sum().minCoeff(), 0.97) << "normals of a sphere";
}

TEST(ResampledValues, AreMeansWeightedByArea) {
  Samples from;
  from.points = Points{{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}, {10, 0, 0}};
  from.normals = Points{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  from.weights = Eigen::Vector4d(1, 1, 3, 1);
  Samples to = from;
  to.points.col(0) << 0, 10, 20, 30;
  const ValueTransfer carried(from, to);
  EXPECT_DOUBLE_EQ(carried.means(Eigen::Vector4d(1, 2, 4, 0))[0], (1 + 2 + 3 * 4) / 5.0);
  EXPECT_EQ(carried.labels({7, 7, 9, 0})[0], 9);
}

TEST(ResampledValues, KeepTheTwoSidesOfASheetSeparate) {
  const Shape sheet = test::box({1, 1, 1e-4}, 12);
  const Samples samples = sample_shape(sheet, SampleSite::faces);
  const Eigen::VectorXd side = samples.normals.col(2);
  const Shape shifted =
      test::transformed(sheet, 1, Eigen::Matrix3d::Identity(), {0.02, 0.01, 8e-5});  // nearer to the other side
  const Samples others = sample_shape(shifted, SampleSite::faces);
  const Eigen::VectorXd carried = ValueTransfer(samples, others).means(side);
  for (Eigen::Index i = 0; i < carried.size(); ++i) {
    if (others.points.row(i).cwiseAbs().maxCoeff() > 0.4) continue;  // the rim is near
    EXPECT_NEAR(carried[i], others.normals(i, 2), 1e-12) << i;
  }
}

TEST(ResampledValues, IgnoreMissingValuesUnlessAllValuesAreMissing) {
  const Samples from = sample_shape(test::sphere(1, 4), SampleSite::faces);
  const Samples to = sample_shape(test::sphere(1, 1), SampleSite::faces);
  const ValueTransfer carried(from, to);
  Eigen::VectorXd values = Eigen::VectorXd::Constant(from.points.rows(), 3);
  for (Eigen::Index i = 0; i < values.size(); i += 2) values[i] = std::nan("");
  EXPECT_NEAR((carried.means(values).array() - 3).abs().maxCoeff(), 0, 1e-12);
  values.setConstant(std::nan(""));
  EXPECT_TRUE(carried.means(values).array().isNaN().all());
}

TEST(CoarseView, KeepsPartsAndValuesOfSeparateBalls) {
  const ShapeView fine = test_view::balls();
  const Samples samples = sample_shape(fine.shape, fine.site);
  const ShapeView coarse = coarse_view(fine, samples, 400);
  ASSERT_LE(coarse.shape.triangles.rows(), 400);
  const Samples coarse_samples = sample_shape(coarse.shape, SampleSite::faces);
  ASSERT_EQ(std::ssize(coarse.parts.front().labels), coarse_samples.points.rows());
  std::set<std::int32_t> parts;
  for (Eigen::Index i = 0; i < coarse_samples.points.rows(); ++i) {
    const bool small = coarse_samples.points(i, 0) > 1.5;
    EXPECT_EQ(coarse.parts.front().labels[static_cast<std::size_t>(i)], small ? 1 : 0);
    EXPECT_NEAR(coarse.fields[0].values[i], small ? 0.5 : 2, 1e-12);
    EXPECT_NEAR(coarse.fields[1].values[i], coarse_samples.points(i, 2), 0.12);
    parts.insert(coarse.parts.front().labels[static_cast<std::size_t>(i)]);
  }
  EXPECT_EQ(parts.size(), 2U);
  EXPECT_EQ(coarse_view(fine, samples, 5000).shape.triangles, fine.shape.triangles);
}

}  // namespace

}  // namespace shapegauge

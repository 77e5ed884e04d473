// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using test::Permuted;

class SamplesAtEachSite : public testing::TestWithParam<SampleSite> {};
INSTANTIATE_TEST_SUITE_P(Both, SamplesAtEachSite, testing::Values(SampleSite::faces, SampleSite::vertices),
                         [](const auto& site) { return site.param == SampleSite::faces ? "faces" : "vertices"; });

TEST_P(SamplesAtEachSite, HaveWeightsThatSumToTheSurfaceArea) {
  for (const Shape& shape :
       {test::sphere(2, 3), test::box({1, 2, 3}, 4), test::capsule(0.1, 20, 12, 3), test::torus(3, 1, 10, 40)}) {
    const Samples samples = sample_shape(shape, GetParam());
    EXPECT_GT(samples.weights.minCoeff(), 0);
    EXPECT_NEAR(samples.weights.sum() / surface_area(shape), 1, 1e-13);
    EXPECT_TRUE(samples.normals.rowwise().norm().isOnes(1e-14));
  }
}

TEST_P(SamplesAtEachSite, HaveOutwardNormalsOnASphere) {
  const Samples samples = sample_shape(test::sphere(2, 4), GetParam());
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    EXPECT_GT(samples.normals.row(i).dot(samples.points.row(i).normalized()), std::cos(0.01));
  }
}

TEST_P(SamplesAtEachSite, MoveAndScaleWithTheShape) {
  const Shape shape = test::capsule(1, 2, 12, 4);
  const Samples before = sample_shape(shape, GetParam());
  const Eigen::Matrix3d rotation = test::rotation(1);
  const Eigen::RowVector3d move(4, -5, 6);
  for (const double scale : {1e-3, 1.0, 1e4}) {
    const Samples after = sample_shape(test::transformed(shape, scale, rotation, move.transpose()), GetParam());
    EXPECT_TRUE(after.points.isApprox(((before.points * scale) * rotation.transpose()).rowwise() + move, 1e-13));
    EXPECT_TRUE(after.normals.isApprox(before.normals * rotation.transpose(), 1e-9));
    EXPECT_TRUE(after.weights.isApprox(before.weights * scale * scale, 1e-9));
  }
}

TEST_P(SamplesAtEachSite, FollowTheOrderOfFacesAndVertices) {
  const Shape shape = test::box({1, 2, 3}, 3);
  const Permuted permuted = test::permuted(shape, 7);
  const Samples before = sample_shape(shape, GetParam());
  const Samples after = sample_shape(permuted.shape, GetParam());
  const auto& order = GetParam() == SampleSite::faces ? permuted.triangles : permuted.vertices;
  ASSERT_EQ(after.points.rows(), static_cast<Eigen::Index>(order.size()));
  for (Eigen::Index i = 0; i < after.points.rows(); ++i) {
    EXPECT_TRUE(after.points.row(i).isApprox(before.points.row(order[i]), 1e-14));
    EXPECT_TRUE(after.normals.row(i).isApprox(before.normals.row(order[i]), 1e-14));
    EXPECT_NEAR(after.weights[i], before.weights[order[i]], 1e-14);
  }
}

TEST_P(SamplesAtEachSite, HaveZeroWeightOnDegenerateTriangles) {
  const Eigen::Vector3d a(1, 2, 3);
  const Eigen::Vector3d b(2, -1, 0.7);
  const Eigen::Vector3d on_the_line = a + (b - a) / 3;
  for (const Shape& shape : {test::soup_of({a, a, a}), test::soup_of({a, a, b}), test::soup_of({a, b, on_the_line}),
                             test::soup_of({1e-200 * a, 1e-200 * b, 1e-200 * on_the_line})}) {
    const Samples samples = sample_shape(shape, GetParam());
    EXPECT_TRUE(samples.weights.isZero(0));
    EXPECT_TRUE(samples.normals.isZero(0));
    EXPECT_TRUE(samples.points.allFinite());
  }
}

TEST_P(SamplesAtEachSite, HaveNormalsOnTinyAndHugeTriangles) {
  for (const double size : {1e-160, 1e150}) {
    const Samples samples = sample_shape(test::soup_of({{0, 0, 0}, {size, 0, 0}, {0, size, 0}}), GetParam());
    EXPECT_TRUE(samples.normals.row(0).isApprox(Eigen::RowVector3d(0, 0, 1), 1e-14));
    EXPECT_TRUE(samples.weights.allFinite());
  }
}

TEST(SamplesAtFaces, AreCentroidsWithTheAreaAsWeight) {
  const Samples samples = sample_shape(test::soup_of({{0, 0, 0}, {3, 0, 0}, {0, 6, 0}}), SampleSite::faces);
  EXPECT_TRUE(samples.points.row(0).isApprox(Eigen::RowVector3d(1, 2, 0), 1e-14));
  EXPECT_DOUBLE_EQ(samples.weights[0], 9);
}

TEST(SamplesAtVertices, HaveVoronoiAreasInAcuteTriangles) {
  // The circumcentre of this triangle is (2, 1.5): each corner's region is two right-angled triangles around it.
  const Samples samples = sample_shape(test::soup_of({{0, 0, 0}, {4, 0, 0}, {2, 4, 0}}), SampleSite::vertices);
  EXPECT_NEAR(samples.weights[0], 1.5 + 1.25, 1e-14);
  EXPECT_NEAR(samples.weights[1], 1.5 + 1.25, 1e-14);
  EXPECT_NEAR(samples.weights[2], 2.5, 1e-14);
}

TEST(SamplesAtVertices, HaveHalfTheAreaAtAnObtuseCorner) {
  const Samples samples = sample_shape(test::soup_of({{0, 0, 0}, {1, 0, 0}, {-1, 1, 0}}), SampleSite::vertices);
  EXPECT_NEAR(samples.weights[0], 0.25, 1e-15);
  EXPECT_NEAR(samples.weights[1], 0.125, 1e-15);
  EXPECT_NEAR(samples.weights[2], 0.125, 1e-15);
}

TEST(SamplesAtVertices, NormalAtABoxCornerDoesNotDependOnTheTriangulation) {
  const Samples samples = sample_shape(test::box({2, 2, 2}, 2), SampleSite::vertices);
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    if (samples.points.row(i).norm() < std::sqrt(3.0) - 1e-9) continue;
    EXPECT_TRUE(samples.normals.row(i).isApprox(samples.points.row(i).normalized(), 1e-14));
  }
}

TEST(SamplesAtVertices, IncludeAllFacesAtANonManifoldEdge) {
  Shape fan = test::soup_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}});
  fan.vertices.conservativeResize(5, 3);
  fan.vertices.bottomRows<2>() << 0, 1, 0, -1, -1, 0;
  fan.triangles.conservativeResize(3, 3);
  fan.triangles.bottomRows<2>() << 0, 1, 3, 0, 1, 4;
  EXPECT_NEAR(sample_shape(fan, SampleSite::vertices).weights.sum(), surface_area(fan), 1e-14);
}

TEST(SamplesAtVertices, NormalFollowsTheMajorityOfFaceOrientations) {
  // Six equal triangles around a vertex, two of them flipped: the sum of normals is a third.
  Shape fan{.vertices = Points::Zero(7, 3), .triangles = {}};
  fan.triangles.resize(6, 3);
  for (int k = 0; k < 6; ++k) {
    const double angle = k * std::numbers::pi / 3;
    fan.vertices.row(k + 1) << std::cos(angle), std::sin(angle), 0;
    fan.triangles.row(k) << 0, 1 + k, 1 + (k + 1) % 6;
  }
  for (const int turned : {1, 4}) std::swap(fan.triangles(turned, 1), fan.triangles(turned, 2));
  EXPECT_NEAR(sample_shape(fan, SampleSite::vertices).normals(0, 2), 1, 1e-12);
  fan.triangles.col(1).swap(fan.triangles.col(2));
  EXPECT_NEAR(sample_shape(fan, SampleSite::vertices).normals(0, 2), -1, 1e-12);
}

TEST(SamplesAtVertices, HaveNoNormalIfUnusedOrIfFaceNormalsCancel) {
  // Two coplanar triangles of opposite orientation with vertex 0 in common.
  const Shape bow{Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {9, 9, 9}},
                  Triangles{{0, 1, 2}, {0, 4, 3}}};
  const Samples samples = sample_shape(test::transformed(bow, 1, test::rotation(3), {1, 2, 3}), SampleSite::vertices);
  EXPECT_TRUE(samples.normals.row(0).isZero(0));
  EXPECT_TRUE(samples.normals.row(5).isZero(0));
  EXPECT_EQ(samples.weights[5], 0);
  EXPECT_NEAR(samples.normals.row(1).dot(samples.normals.row(3)), -1, 1e-14);
  EXPECT_NEAR(samples.weights.sum(), 1, 1e-14);
}

TEST(SamplesAtVertices, NormalIsTheCommonAxisOfPartlyReversedTriangles) {
  const auto apex = [](double height, const Triangles& triangles) -> Eigen::RowVector3d {
    const Shape pyramid{Points{{0, 0, height}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, triangles};
    return sample_shape(pyramid, SampleSite::vertices).normals.row(0);
  };
  // The sum of these normals is horizontal.
  EXPECT_NEAR(std::abs(apex(0.3, Triangles{{0, 2, 1}, {0, 3, 2}, {0, 3, 4}, {0, 4, 1}}).z()), 1, 1e-12);
  // A needle's normals nearly cancel, but have no common axis.
  EXPECT_NEAR(apex(5, Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}).z(), 1, 1e-12);
}

TEST(SamplesAtVertices, OfADoubledSheetHaveTheNormalsOfItsFirstLayer) {
  Shape sheet = test::soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  sheet.triangles.conservativeResize(2, 3);
  sheet.triangles.bottomRows<1>() << 2, 1, 0;
  const Samples samples = sample_shape(sheet, SampleSite::vertices);
  EXPECT_EQ(samples.normals, (Points{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}));
  EXPECT_NEAR(samples.weights.sum(), 0.5, 1e-15);
}

TEST(Samples, OfAnEmptyShapeAreEmpty) { EXPECT_EQ(sample_shape(Shape{}, SampleSite::faces).points.rows(), 0); }

TEST_P(SamplesAtEachSite, OfACloudAreItsPoints) {
  Shape cloud{test::box({1, 1, 1}, 3).vertices, {}, {}};
  const Samples without_normals = sample_shape(cloud, GetParam());
  EXPECT_EQ(without_normals.site, SampleSite::vertices);
  EXPECT_EQ(without_normals.points, cloud.vertices);
  EXPECT_EQ(without_normals.normals, unsigned_point_normals(cloud.vertices));
  EXPECT_EQ(without_normals.weights, point_weights(cloud.vertices));
  cloud.normals = cloud.vertices.rowwise().normalized();
  cloud.normals.row(1).setZero();
  EXPECT_EQ(sample_shape(cloud, GetParam()).normals, cloud.normals);
}

TEST(SamplesOfTheSurface, AreUniformByAreaAndOnTheirTriangles) {
  // Two squares, one of nine times the other's area.
  const Shape sheet{
      .vertices = Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 0, 0}, {8, 0, 0}, {8, 3, 0}, {5, 3, 0}},
      .triangles = Triangles{{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}}};
  const Samples samples = sample_surface(sheet, 1000);
  EXPECT_EQ(samples.site, SampleSite::surface);
  EXPECT_NEAR(samples.weights.sum(), 10, 1e-9);
  EXPECT_EQ(samples.weights.minCoeff(), samples.weights.maxCoeff());
  EXPECT_EQ((samples.points.col(0).array() < 2).count(), 100);  // points are stratified by area
  for (Eigen::Index i = 0; i < 1000; ++i) {
    const bool of_small = samples.points(i, 0) < 2;
    EXPECT_EQ(samples.triangles[static_cast<std::size_t>(i)] < 2, of_small) << i;
    EXPECT_EQ(samples.normals(i, 2), of_small ? 1 : -1) << i;
  }
  EXPECT_EQ(samples.points, sample_surface(sheet, 1000).points);
  EXPECT_THROW(sample_surface(sheet, 0), InputError);
  EXPECT_THROW(sample_shape(sheet, SampleSite::surface), InputError);
}

TEST(SamplesOfTheSurface, AreUniformWithinATriangle) {
  constexpr Eigen::Index count = 20000;
  const Samples samples = sample_surface(test::soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), count);
  // Means of uniform points: 1/3 of each coordinate, 1/6 of its square, 1/12 of the product.
  const Eigen::ArrayXd x = samples.points.col(0).array();
  const Eigen::ArrayXd y = samples.points.col(1).array();
  constexpr double error = 0.006;  // three and a half standard errors of the first
  EXPECT_NEAR(x.mean(), 1.0 / 3, error);
  EXPECT_NEAR(y.mean(), 1.0 / 3, error);
  EXPECT_NEAR(x.square().mean(), 1.0 / 6, error);
  EXPECT_NEAR(y.square().mean(), 1.0 / 6, error);
  EXPECT_NEAR((x * y).mean(), 1.0 / 12, error);
}

TEST(SamplesOfTheSurface, OfACloudAreASubsetWithTheTotalArea) {
  const Shape cloud{test::box({1, 1, 1}, 6).vertices, {}, {}};
  const Samples all = sample_shape(cloud, SampleSite::vertices);
  const Samples some = sample_surface(cloud, 50);
  EXPECT_EQ(some.site, SampleSite::vertices);
  EXPECT_EQ(some.points.rows(), 50);
  EXPECT_NEAR(some.weights.sum(), all.weights.sum(), 1e-9);
  EXPECT_EQ(sample_surface(cloud, 100000).points, all.points);
}

}  // namespace

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/segmentation/segmentation_proxy.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

TEST(SegmentationProxy, KeepsFineMeshesAndCloudsUnchanged) {
  for (const Shape& shape : {test::sphere(1, 5), test::random_points(test::sphere(1, 3), 500, 1)}) {
    const SegmentationProxy result = segmentation_proxy(shape);
    EXPECT_EQ(result.shape.vertices, shape.vertices);
    EXPECT_EQ(result.shape.triangles, shape.triangles);
    std::vector<std::int32_t> nodes(result.node_of.size());
    std::iota(nodes.begin(), nodes.end(), 0);
    EXPECT_EQ(result.transfer(nodes), nodes);
  }
}

TEST(SegmentationProxy, SubdividesCoarseMeshes) {
  for (const Shape& shape : {test::box({1, 2, 3}, 1), test::sphere(1, 3), test::soup(test::sphere(1, 2))}) {
    const SegmentationProxy result = segmentation_proxy(shape);
    EXPECT_GE(result.shape.triangles.rows(), 8000);
    EXPECT_LT(result.shape.triangles.rows(), 4 * 8000);
    EXPECT_TRUE(is_closed_and_oriented(result.shape));
    EXPECT_NEAR(surface_area(result.shape), surface_area(shape), 1e-12 * surface_area(shape));
    EXPECT_NEAR(signed_volume(result.shape), signed_volume(shape), 1e-12 * signed_volume(shape));
    // Each triangle is identified by a small one with the same centroid.
    const Points centroids = sample_shape(shape, SampleSite::faces).points;
    const Points fine = sample_shape(result.shape, SampleSite::faces).points;
    for (std::size_t t = 0; t < result.node_of.size(); ++t) {
      EXPECT_LT((centroids.row(static_cast<Eigen::Index>(t)) - fine.row(result.node_of[t])).norm(), 1e-12);
    }
  }
}

TEST(SegmentationProxy, HasFiniteVerticesForMeshesWithDegenerateTriangles) {
  Shape shape = test::box({1, 1, 1}, 1);
  shape.triangles.conservativeResize(shape.triangles.rows() + 1, 3);
  shape.triangles.bottomRows(1) << 0, 0, 1;
  const SegmentationProxy result = segmentation_proxy(shape);
  EXPECT_EQ(result.node_of.size(), 13U);
  EXPECT_TRUE(result.shape.vertices.allFinite());
  EXPECT_NEAR(surface_area(result.shape), 6, 1e-12);
}

TEST(SegmentationProxy, ReplacesCrackedMeshesByClouds) {
  RandomNumbers random(1);
  const Shape whole = test::sphere(1, 5);
  const Shape cracked = remove_faces(whole, 0.15, random);
  const SegmentationProxy result = segmentation_proxy(cracked);
  ASSERT_TRUE(is_cloud(result.shape));
  EXPECT_EQ(result.shape.vertices.rows(), 10000);
  const Points centroids = sample_shape(cracked, SampleSite::faces).points;
  for (std::size_t t = 0; t < result.node_of.size(); ++t) {
    const double distance =
        (centroids.row(static_cast<Eigen::Index>(t)) - result.shape.vertices.row(result.node_of[t])).norm();
    EXPECT_LT(distance, 0.1);  // 10,000 points of a sphere of radius 1 are 0.035 apart
  }
  EXPECT_EQ(segmentation_proxy(cracked).shape.vertices, result.shape.vertices);
}

TEST(SegmentationProxy, ReplacesMeshesByCloudsOnlyIfManyTrianglesAreMissing) {
  // Each missing triangle opens three of 1.5 edges a triangle: 4 and 6 % of them.
  for (const double missing : {0.02, 0.03}) {
    RandomNumbers random(1);
    EXPECT_EQ(is_cloud(segmentation_proxy(remove_faces(test::sphere(1, 5), missing, random)).shape), missing == 0.03)
        << missing;
  }
}

TEST(SegmentationProxy, DoesNotReplaceAMeshWithALargeHoleByACloud) {
  const Shape whole = test::sphere(1, 5);
  Shape open = whole;
  open.triangles = whole.triangles.topRows(whole.triangles.rows() / 2);
  EXPECT_FALSE(is_cloud(segmentation_proxy(open).shape));
}

}  // namespace

}  // namespace shapegauge

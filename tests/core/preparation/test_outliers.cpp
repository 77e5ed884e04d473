// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/preparation/outliers.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Random points on the unit sphere, followed by outliers at distances of 3 to 2 + count.
Shape with_outliers(Eigen::Index count) {
  Shape cloud = test::random_points(test::sphere(1, 4), 2000, 1);
  cloud.normals = cloud.vertices.rowwise().normalized();
  cloud.vertices.conservativeResize(2000 + count, Eigen::NoChange);
  cloud.normals.conservativeResize(2000 + count, Eigen::NoChange);
  for (Eigen::Index i = 0; i < count; ++i) {
    cloud.vertices.row(2000 + i) << 0, 0, 3 + static_cast<double>(i);
    cloud.normals.row(2000 + i) << 1, 0, 0;
  }
  return cloud;
}

TEST(CloudOutliers, AreTheIsolatedPointsOfACloud) {
  const Shape cloud = with_outliers(5);
  const std::vector<bool> marked = outliers(cloud);
  for (std::size_t i = 0; i < marked.size(); ++i) EXPECT_EQ(marked[i], i >= 2000) << i;
  const Shape clean = without_outliers(cloud);
  EXPECT_EQ(clean.vertices, cloud.vertices.topRows(2000));
  EXPECT_EQ(clean.normals, cloud.normals.topRows(2000));
  EXPECT_NEAR(positive_area(clean), 4 * 3.14159, 0.4);
  EXPECT_EQ(prepare_shape(cloud, {.remove_outliers = true}).area, positive_area(clean));
}

TEST(CloudOutliers, AreNotFoundInCleanCloudsAndMeshes) {
  EXPECT_EQ(outlier_count(with_outliers(0)), 0U);
  EXPECT_EQ(outlier_count(with_outliers(40)), 0U) << "2 % of the points";
  EXPECT_EQ(outlier_count(test::sphere(1, 2)), 0U);
  EXPECT_EQ(outlier_count({}), 0U);
  EXPECT_EQ(outlier_count({Points::Zero(1, 3), {}}), 0U);
  Shape repeated{.vertices = Points::Zero(1000, 3), .triangles = {}};
  for (Eigen::Index i = 0; i < 994; ++i) repeated.vertices(i, 0) = static_cast<double>(i / 7);
  repeated.vertices.bottomRows(6).col(1).setLinSpaced(1, 6);
  EXPECT_EQ(outlier_count(repeated), 0U) << "a spacing of 0";
}

}  // namespace
}  // namespace shapegauge

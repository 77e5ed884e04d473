// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/preparation/stray_normals.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Random points on the unit sphere, with their normals.
Shape ball() {
  Shape cloud = test::random_points(test::sphere(1, 4), 2000, 1);
  cloud.normals = cloud.vertices.rowwise().normalized();
  return cloud;
}

/// Directions of the points of another random sample of the sphere.
Points random_directions() { return test::random_points(test::sphere(1, 4), 2000, 2).vertices; }

TEST(StrayNormals, AreNormalsUnrelatedToTheSurface) {
  Shape cloud = ball();
  EXPECT_FALSE(has_stray_normals(cloud));
  cloud.normals.topRows(1000) *= -3;
  EXPECT_FALSE(has_stray_normals(cloud)) << "signs and lengths do not matter";
  cloud.normals = random_directions();
  EXPECT_TRUE(has_stray_normals(cloud));
  EXPECT_TRUE(diagnose(cloud).stray_normals);
  cloud.normals = Eigen::RowVector3d(0, 0, -2).replicate(2000, 1);
  EXPECT_TRUE(has_stray_normals(cloud)) << "half of a sphere has |z| below 0.5";
  cloud.normals.topRows(1500).setZero();
  EXPECT_TRUE(has_stray_normals(cloud)) << "zero normals are unknown";
}

TEST(StrayNormals, AreNotReportedForPlatesVolumesAndMeshes) {
  Shape cloud = ball();
  cloud.vertices = Points::Random(2000, 3);
  EXPECT_FALSE(has_stray_normals(cloud)) << "points of a volume have no surface";
  Shape plate = ball();
  plate.vertices.col(2).setZero();
  plate.normals = Eigen::RowVector3d(0, 0, 1).replicate(2000, 1);
  EXPECT_FALSE(has_stray_normals(plate));
  EXPECT_FALSE(has_stray_normals(test::sphere(1, 2)));
  EXPECT_FALSE(has_stray_normals({}));
  EXPECT_FALSE(has_stray_normals({Points::Zero(1, 3), {}}));
}

TEST(StrayNormals, AreRemovedWhenAShapeIsPrepared) {
  Shape cloud = ball();
  EXPECT_EQ(prepare_shape(cloud, {}).shape.normals, cloud.normals);
  cloud.normals = random_directions();
  EXPECT_EQ(prepare_shape(cloud, {}).shape.normals.rows(), 0);
  EXPECT_TRUE(remove_stray_normals(cloud));
  EXPECT_FALSE(remove_stray_normals(cloud));
}

}  // namespace
}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/render/splats.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

Shape sphere_cloud() { return test::random_points(test::sphere(1, 5), 3000, 1); }

TEST(Splats, LieInTheTangentPlanesAndOverlap) {
  const Shape cloud = sphere_cloud();
  const Shape mesh = splats(cloud);
  const Samples faces = sample_shape(mesh, SampleSite::faces);
  ASSERT_EQ(mesh.triangles.rows(), triangles_per_splat * cloud.vertices.rows());
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Eigen::RowVector3d point = cloud.vertices.row(f / triangles_per_splat);
    EXPECT_NEAR(faces.normals.row(f).dot(faces.points.row(f) - point), 0, 1e-12);
    EXPECT_GT(std::abs(faces.normals.row(f).dot(point.normalized())), 0.97);
  }
  EXPECT_GT(surface_area(mesh), 3 * 4 * 3.14);
}

TEST(Splats, UseTheNormalsOfTheCloud) {
  Shape cloud = sphere_cloud();
  cloud.normals = Points::Zero(cloud.vertices.rows(), 3);
  cloud.normals.row(0) << 0.6, 0, 0.8;
  const Samples faces = sample_shape(splats(cloud), SampleSite::faces);
  EXPECT_TRUE(faces.normals.row(0).isApprox(cloud.normals.row(0), 1e-9));
  EXPECT_GT(std::abs(faces.normals.row(triangles_per_splat).dot(cloud.vertices.row(1))), 0.97);
}

TEST(Splats, ScaleWithTheCloudAndHaveSizeZeroForCoincidentPoints) {
  for (const double scale : {1e-30, 1e30}) {
    Shape cloud = sphere_cloud();
    cloud.vertices *= scale;
    EXPECT_NEAR(bounding_box_diagonal(splats(cloud)) / scale, bounding_box_diagonal(splats(sphere_cloud())), 1e-6);
  }
  const Shape coincident{Points::Ones(3, 3), {}, {}};
  EXPECT_EQ(bounding_box_diagonal(splats(coincident)), 0);
  const Shape line{(Points(3, 3) << 0, 0, 0, 1, 0, 0, 3, 0, 0).finished(), {}, {}};
  EXPECT_TRUE(splats(line).vertices.allFinite());
}

TEST(Splats, AreRegularHexagonsProportionalToTheAreaOfTheirPoint) {
  const Shape cloud = test::random_points(test::sphere(3, 4), 400, 2);
  const Shape mesh = splats(cloud);
  const Eigen::VectorXd weights = point_weights(cloud.vertices);
  constexpr int corners = 6;
  ASSERT_EQ(mesh.vertices.rows(), corners * cloud.vertices.rows());
  const Eigen::VectorXd areas = triangle_areas(mesh);
  for (Eigen::Index i = 0; i < cloud.vertices.rows(); ++i) {
    // 2.25 times the radius of the disc with the point's area.
    const double radius = 2.25 * std::sqrt(weights[i] / std::numbers::pi);
    for (int k = 0; k < corners; ++k) {
      const Eigen::RowVector3d corner = mesh.vertices.row(corners * i + k);
      EXPECT_NEAR((corner - cloud.vertices.row(i)).norm(), radius, 1e-9);
      EXPECT_NEAR((corner - mesh.vertices.row(corners * i + (k + 1) % corners)).norm(), radius, 1e-9);
    }
    const double area = areas.segment(triangles_per_splat * i, triangles_per_splat).sum();
    EXPECT_NEAR(area, 1.5 * std::sqrt(3) * radius * radius, 1e-9) << "the triangles do not overlap";
  }
}

TEST(Splats, CoverNearlyAllOfAPlanarRandomCloud) {
  RandomNumbers random(3);
  constexpr Eigen::Index count = 1500;
  Shape cloud{Points::Zero(count, 3), {}, {}};
  for (Eigen::Index i = 0; i < count; ++i) cloud.vertices.row(i) << random.uniform(0, 1), random.uniform(0, 1), 0;
  const Eigen::Matrix3d rotation = test::rotation(5);
  const Shape mesh = splats(test::transformed(cloud, 1, rotation, {1, 2, 3}));
  // Back in the plane.
  const Points flat = (mesh.vertices.rowwise() - Eigen::RowVector3d(1, 2, 3)) * rotation;
  EXPECT_LT(flat.col(2).cwiseAbs().maxCoeff(), 1e-9);
  int uncovered = 0;
  constexpr int trials = 1000;
  for (int trial = 0; trial < trials; ++trial) {
    const Eigen::RowVector2d x{random.uniform(0.1, 0.9), random.uniform(0.1, 0.9)};
    bool is_covered = false;
    for (Eigen::Index i = 0; i < count && !is_covered; ++i) {
      int left = 0;
      for (int k = 0; k < 6; ++k) {
        const Eigen::RowVector2d a = flat.row(6 * i + k).head<2>() - x;
        const Eigen::RowVector2d b = flat.row(6 * i + (k + 1) % 6).head<2>() - x;
        left += a.x() * b.y() > a.y() * b.x() ? 1 : 0;
      }
      is_covered = left == 0 || left == 6;
    }
    uncovered += is_covered ? 0 : 1;
  }
  // A hexagon has 0.83 of the area of its circle: exp(-0.83 * 2.25^2), or 1.5 %, if all hexagons were equal.
  EXPECT_LT(uncovered, 0.03 * trials);
}

TEST(Splats, RejectNonFinitePoints) {
  Shape cloud = sphere_cloud();
  cloud.vertices(7, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(splats(cloud), InputError);
}

}  // namespace

}  // namespace shapegauge

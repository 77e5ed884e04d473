#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/render/splats.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/core/random_points.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

Shape sphere_cloud() { return test_shapes::random_points(test_shapes::sphere(1, 5), 3000, 1); }

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

TEST(Splats, TakeTheCloudsNormalsWhereItHasThem) {
  Shape cloud = sphere_cloud();
  cloud.normals = Points::Zero(cloud.vertices.rows(), 3);
  cloud.normals.row(0) << 0.6, 0, 0.8;
  const Samples faces = sample_shape(splats(cloud), SampleSite::faces);
  EXPECT_TRUE(faces.normals.row(0).isApprox(cloud.normals.row(0), 1e-9));
  EXPECT_GT(std::abs(faces.normals.row(triangles_per_splat).dot(cloud.vertices.row(1))), 0.97);
}

TEST(Splats, OfAnySizeAndOfNone) {
  for (const double scale : {1e-30, 1e30}) {
    Shape cloud = sphere_cloud();
    cloud.vertices *= scale;
    EXPECT_NEAR(bounding_box_diagonal(splats(cloud)) / scale, bounding_box_diagonal(splats(sphere_cloud())), 1e-6);
  }
  const Shape one_place{Points::Ones(3, 3), {}, {}};
  EXPECT_EQ(bounding_box_diagonal(splats(one_place)), 0);
  const Shape line{(Points(3, 3) << 0, 0, 0, 1, 0, 0, 3, 0, 0).finished(), {}, {}};
  EXPECT_TRUE(splats(line).vertices.allFinite());
}

}  // namespace
}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/decimate.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using test::signed_volume;

void expect_valid(const Shape& mesh) {
  ASSERT_GT(mesh.triangles.rows(), 0);
  EXPECT_GE(mesh.triangles.minCoeff(), 0);
  EXPECT_EQ(mesh.triangles.maxCoeff(), mesh.vertices.rows() - 1);
  EXPECT_GT(triangle_areas(mesh).minCoeff(), 0);
}

TEST(Decimate, KeepsASphereClosedWithItsVolumeAndOutwardNormals) {
  const Shape sphere = test::sphere(1, 5);  // 20480 faces
  const Shape coarse = decimate(sphere, 1000);
  expect_valid(coarse);
  EXPECT_LE(coarse.triangles.rows(), 1000);
  EXPECT_GE(coarse.triangles.rows(), 998);
  EXPECT_TRUE(is_closed(coarse));
  // A polyhedron of n similar triangles inscribed in the unit sphere loses at least about 4 pi / (n sqrt(3)) of its
  // volume.
  EXPECT_NEAR(signed_volume(coarse) / signed_volume(sphere), 1, 0.015);
  const Samples faces = sample_shape(coarse, SampleSite::faces);
  for (Eigen::Index f = 0; f < coarse.triangles.rows(); ++f) {
    EXPECT_GT(faces.normals.row(f).dot(faces.points.row(f)), 0) << f;
  }
}

TEST(Decimate, KeepsVolumeAndAreaOfABox) {
  const Shape box = test::box({1, 2, 3}, 8);
  const Shape coarse = decimate(box, 40);
  expect_valid(coarse);
  EXPECT_TRUE(is_closed(coarse));
  EXPECT_LE(coarse.triangles.rows(), 40);
  EXPECT_NEAR(signed_volume(coarse), 6, 1e-12);
  EXPECT_NEAR(surface_area(coarse), 22, 1e-12);
}

TEST(Decimate, KeepsTheRimOfAnOpenPlate) {
  Shape plate = test::box({1, 2, 0}, 10);
  Eigen::Index side = 0;  // one of the sides of the flat box
  const Eigen::VectorXd areas = triangle_areas(plate);
  while (areas[side] == 0) ++side;
  plate.triangles = plate.triangles.middleRows(side, 200).eval();
  ASSERT_NEAR(surface_area(plate), 2, 1e-12);
  const Shape coarse = decimate(plate, 10);
  expect_valid(coarse);
  EXPECT_LE(coarse.triangles.rows(), 10);
  EXPECT_NEAR(surface_area(coarse), 2, 1e-12);
}

TEST(Decimate, WeldsTheVerticesOfATriangleSoup) {
  const Shape sphere = test::sphere(1, 3);
  const Shape coarse = decimate(test::soup(sphere), 200);
  EXPECT_TRUE(is_closed(coarse));
  EXPECT_LE(coarse.triangles.rows(), 200);
  EXPECT_LE(coarse.vertices.rows(), 102);
}

TEST(Decimate, KeepsTheOrientationOfEveryFace) {
  const Shape sphere = test::sphere(1, 4);
  RandomNumbers random(1);
  const Shape mixed = decimate(flip_orientation(sphere, 0.5, random), 500);
  EXPECT_LE(mixed.triangles.rows(), 500);
  EXPECT_TRUE(is_closed(mixed));
  const Samples faces = sample_shape(mixed, SampleSite::faces);
  const Eigen::VectorXd cosines = faces.points.cwiseProduct(faces.normals).rowwise().sum();
  const auto outward = static_cast<double>((cosines.array() > 0).count());
  EXPECT_NEAR(outward / static_cast<double>(mixed.triangles.rows()), 0.5, 0.15);
}

TEST(Decimate, KeepsTwoBoxesWithACommonEdgeClosed) {
  // Two boxes with a common edge, shared by four faces.
  const Shape box = test::box({1, 1, 1}, 6);
  const Shape pair = test::joined({box, test::transformed(box, 1, Eigen::Matrix3d::Identity(), {1, 1, 0})});
  const Shape coarse = decimate(pair, 200);
  expect_valid(coarse);
  EXPECT_TRUE(is_closed(coarse));
  EXPECT_LE(coarse.triangles.rows(), 200);
  EXPECT_NEAR(signed_volume(coarse), 2, 1e-12);
}

TEST(Decimate, SimplifiesMeshesWithMissingFaces) {
  RandomNumbers random(1);
  const Shape broken = remove_faces(test::sphere(1, 4), 0.15, random);
  const Shape coarse = decimate(broken, 1500);
  expect_valid(coarse);
  EXPECT_LT(coarse.triangles.rows(), broken.triangles.rows() / 2 + 500);
}

TEST(Decimate, IsInvariantToSizeAndPosition) {
  const Shape torus = test::torus(3, 1, 40, 30);
  Shape tiny = torus;
  tiny.vertices *= 0x1p-200;
  EXPECT_EQ(decimate(tiny, 500).triangles, decimate(torus, 500).triangles);
}

TEST(Decimate, ReturnsSmallMeshesUnchanged) {
  const Shape box = test::box({1, 1, 1}, 2);
  EXPECT_EQ(decimate(box, 48).triangles, box.triangles);
}

TEST(Decimate, RejectsCloudsEmptyShapesAndUnreachableNumbersOfFaces) {
  const Shape cloud{.vertices = test::sphere(1, 2).vertices, .triangles = {}};
  EXPECT_THROW(decimate(cloud, 100), InputError);
  EXPECT_THROW(decimate(Shape{}, 100), InputError);
  EXPECT_THROW(decimate(test::sphere(1, 2), 0), InputError);
  const Shape tetrahedron{.vertices = Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                          .triangles = Triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  EXPECT_THROW(decimate(tetrahedron, 3), InputError);
}

}  // namespace

}  // namespace shapegauge

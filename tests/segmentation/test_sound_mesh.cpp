// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/segmentation/sound_mesh.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using Labels = std::vector<std::int32_t>;

TEST(SoundMesh, AssignsDegenerateTrianglesToTheClosestValidTriangle) {
  // Two triangles far apart; the others are a point of the first, an edge of the second, and a duplicate of the second.
  const Shape mesh{.vertices = Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 1, 0}},
                   .triangles = Triangles{{1, 1, 1}, {0, 1, 2}, {3, 5, 6}, {3, 4, 5}, {5, 4, 3}}};
  const SoundMesh sound = sound_mesh(mesh);
  ASSERT_EQ(sound.shape.triangles.rows(), 2);
  EXPECT_EQ(sound.shape.triangles.row(0), mesh.triangles.row(1));
  EXPECT_EQ(sound.shape.triangles.row(1), mesh.triangles.row(3));
  EXPECT_EQ(sound.extended({7, 9}), (Labels{7, 7, 9, 9, 9}));
}

TEST(SoundMesh, AssignsAFarDegenerateTriangleToTheNearestSideOfABox) {
  Shape mesh = test::box({1, 1, 1}, 1);
  const Eigen::Index vertices = mesh.vertices.rows();
  const Eigen::Index triangles = mesh.triangles.rows();
  mesh.vertices.conservativeResize(vertices + 1, Eigen::NoChange);
  mesh.vertices.bottomRows(1) << 1e30, 0, 0;
  mesh.triangles.conservativeResize(triangles + 1, Eigen::NoChange);
  mesh.triangles.bottomRows(1).setConstant(static_cast<std::int32_t>(vertices));
  const SoundMesh sound = sound_mesh(mesh);
  ASSERT_EQ(sound.shape.triangles.rows(), triangles);
  const std::int32_t closest = sound.triangle_of.back();
  for (int k = 0; k < 3; ++k) EXPECT_EQ(mesh.vertices(sound.shape.triangles(closest, k), 0), 0.5);
}

TEST(SoundMesh, KeepsMeshesWithoutDefectsAndCloudsUnchanged) {
  const Shape sphere = test::sphere(1, 2);
  EXPECT_EQ(sound_mesh(sphere).shape.triangles, sphere.triangles);
  const Shape cloud{.vertices = Points::Identity(3, 3), .triangles = {}};
  EXPECT_EQ(sound_mesh(cloud).extended({1, 2, 3}), (Labels{1, 2, 3}));
}

TEST(SoundMesh, RejectsAMeshOfDegenerateTrianglesOnly) {
  const Shape mesh{.vertices = Points::Identity(3, 3), .triangles = Triangles{{0, 1, 1}}};
  EXPECT_THROW(sound_mesh(mesh), InputError);
}

}  // namespace

}  // namespace shapegauge

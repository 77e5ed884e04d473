// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/shape/polygons.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

using Labels = std::vector<std::int32_t>;

/// Polygon 0 has triangles of area 0.5, 1 and 0.5; polygon 1 has none; polygon 2 has one.
Shape mesh_of_three_polygons() {
  Shape shape{.vertices = Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 2, 0}, {-1, 0, 0}},
              .triangles = Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 3, 4}}};
  shape.polygons = {.of_triangle = {0, 0, 0, 2}, .count = 3};
  return shape;
}

TEST(Polygons, HaveTheLabelThatCoversTheLargestArea) {
  const Shape shape = mesh_of_three_polygons();
  EXPECT_THAT(labels_of_polygons(shape, Labels{4, 3, 4, 2}), ElementsAre(3, 0, 2)) << "as much of both";
  EXPECT_THAT(labels_of_polygons(shape, Labels{4, 5, 5, 2}), ElementsAre(5, 0, 2));
  EXPECT_THAT(labels_of_polygons(shape, Labels{6, 1, 6, 2}), ElementsAre(1, 0, 2));
  EXPECT_THAT(labels_of_polygons(shape, Labels{1, 7, 1, 2}), ElementsAre(1, 0, 2));
  Shape triangles = shape;
  triangles.polygons = {};
  EXPECT_THAT(labels_of_polygons(triangles, Labels{4, 3, 4, 2}), ElementsAre(4, 3, 4, 2));
}

TEST(Polygons, GiveTheirLabelToTheirTriangles) {
  EXPECT_THAT(labels_of_triangles(mesh_of_three_polygons(), Labels{7, 8, 9}), ElementsAre(7, 7, 7, 9));
}

TEST(Polygons, DivideTheirWeightEvenlyAmongTriangles) {
  EXPECT_THAT(polygon_shares(mesh_of_three_polygons()), ElementsAre(1.0 / 3, 1.0 / 3, 1.0 / 3, 1));
}

TEST(Polygons, NoteIsGivenForPolygonMeshesAndNotForTriangleMeshes) {
  Shape shape = mesh_of_three_polygons();
  EXPECT_TRUE(polygon_note(shape));
  shape.polygons = {};
  EXPECT_FALSE(polygon_note(shape));
}

TEST(Polygons, AreDroppedIfTrianglesAreRemoved) {
  RandomNumbers random(1);
  EXPECT_TRUE(has_polygons(vertex_noise(mesh_of_three_polygons(), {.amplitude = 0.1}, random)));
  EXPECT_TRUE(has_polygons(flip_orientation(mesh_of_three_polygons(), 0.5, random)));
  EXPECT_FALSE(has_polygons(remove_faces(mesh_of_three_polygons(), 0.5, random)));
}

}  // namespace

}  // namespace shapegauge

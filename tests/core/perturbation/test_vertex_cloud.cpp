#include <gtest/gtest.h>

#include "shapegauge/core/perturbation/vertex_cloud.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

TEST(VertexCloud, HasTheVerticesThatTrianglesUse) {
  Shape sphere = test_shapes::sphere(1, 1);
  const Points used = sphere.vertices;
  sphere.vertices.conservativeResize(used.rows() + 1, 3);
  sphere.vertices.bottomRows(1).setConstant(9);
  const Shape cloud = vertex_cloud(sphere);
  EXPECT_TRUE(is_cloud(cloud));
  EXPECT_EQ(cloud.vertices, used);
}

TEST(VertexCloud, OfACloudIsItsPoints) {
  const Points points = test_shapes::sphere(1, 1).vertices;
  const Shape cloud = vertex_cloud({points, {}, points});
  EXPECT_EQ(cloud.vertices, points);
  EXPECT_EQ(cloud.normals.rows(), 0);
}

}  // namespace
}  // namespace shapegauge

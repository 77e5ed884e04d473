// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/distinct_triangles.h"
#include "tests/support/doubled_shapes.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using Indices = std::vector<std::int32_t>;

/// Vertices 4 and 5 coincide with 0 and 1.
Points seven_vertices() {
  return Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-0.0, 0, 0}, {1, 0, 0}, {9, 9, 9}};
}

TEST(DistinctTriangles, AreTheFirstOfTrianglesWithTheSameCorners) {
  const Shape shape{seven_vertices(), Triangles{{0, 1, 2}, {0, 1, 3}, {2, 1, 0}, {2, 4, 5}, {1, 3, 0}, {1, 2, 3}}};
  EXPECT_EQ(first_duplicates(shape.triangles, welded_vertices(shape.vertices)), (Indices{0, 1, 0, 0, 1, 5}));
  const DistinctTriangles found = distinct_triangles(shape);
  EXPECT_TRUE(found.has_duplicates());
  EXPECT_EQ(found.shape.triangles, (Triangles{{0, 1, 2}, {0, 1, 3}, {1, 2, 3}}));
  EXPECT_EQ(found.shape.vertices, shape.vertices);
  EXPECT_EQ(found.triangle_of, (Indices{0, 1, 0, 0, 1, 2}));
  EXPECT_EQ(found.vertex_of, (Indices{0, 1, 2, 3, 0, 1, 6})) << "vertex 6 no triangle uses";
}

TEST(DistinctTriangles, RemovingDuplicatesKeepsVerticesOfOtherTriangles) {
  const Shape shape{seven_vertices(), Triangles{{0, 1, 2}, {4, 5, 2}, {4, 3, 2}}};
  EXPECT_EQ(distinct_triangles(shape).vertex_of, (Indices{0, 1, 2, 3, 4, 1, 6}));
}

TEST(DistinctTriangles, DistinguishDegenerateTrianglesByTheirRepeatedCorner) {
  const Shape shape{seven_vertices(), Triangles{{0, 0, 1}, {0, 1, 1}, {1, 0, 4}}};
  EXPECT_EQ(distinct_triangles(shape).triangle_of, (Indices{0, 1, 0}));
}

TEST(DistinctTriangles, AreAllTrianglesOfAMeshWithoutDuplicates) {
  for (const auto& [name, shape] : test::shapes_without_duplicates()) {
    const DistinctTriangles found = distinct_triangles(shape);
    EXPECT_FALSE(found.has_duplicates()) << name;
    EXPECT_EQ(found.shape.triangles, shape.triangles) << name;
    for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(shape)) {
      EXPECT_EQ(without_duplicates(doubled.shape).triangles, shape.triangles) << name << ", " << doubled.name;
      EXPECT_EQ(distinct_triangles(doubled.shape).triangle_of, doubled.triangles) << name << ", " << doubled.name;
    }
  }
}

TEST(DistinctTriangles, KeepTheAssignmentToPolygonsOnlyWithoutDuplicates) {
  Shape shape{seven_vertices(), Triangles{{0, 1, 2}, {0, 2, 3}, {2, 1, 0}}};
  shape.polygons = {.of_triangle = {0, 0, 1}, .count = 2};
  EXPECT_TRUE(without_duplicates(shape).polygons.of_triangle.empty()) << "they are those of a list of other triangles";
  shape.triangles.row(2) << 1, 2, 3;
  EXPECT_EQ(without_duplicates(shape).polygons.of_triangle, (Indices{0, 0, 1}));
}

TEST(DistinctTriangles, OfACloudAreEmpty) {
  const DistinctTriangles found = distinct_triangles({seven_vertices(), {}});
  EXPECT_FALSE(found.has_duplicates());
  EXPECT_TRUE(is_cloud(found.shape));
  EXPECT_EQ(found.vertex_of.size(), 7U);
}

}  // namespace

}  // namespace shapegauge

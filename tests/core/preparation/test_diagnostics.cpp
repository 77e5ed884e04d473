// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/shape/connectivity.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

/// The cube of edge 1 with eight vertices and twelve triangles.
Shape cube() {
  return {.vertices = Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
          .triangles = Triangles{{0, 2, 1},
                                 {0, 3, 2},
                                 {4, 5, 6},
                                 {4, 6, 7},
                                 {0, 1, 5},
                                 {0, 5, 4},
                                 {1, 2, 6},
                                 {1, 6, 5},
                                 {2, 3, 7},
                                 {2, 7, 6},
                                 {3, 0, 4},
                                 {3, 4, 7}}};
}

Shape with_triangle(Shape shape, int a, int b, int c) {
  shape.triangles.conservativeResize(shape.triangles.rows() + 1, Eigen::NoChange);
  shape.triangles.bottomRows(1) << a, b, c;
  return shape;
}

TEST(Diagnose, FindsNoDefectsInACube) {
  const ShapeDiagnostics found = diagnose(cube());
  EXPECT_TRUE(found.closed);
  EXPECT_EQ(found.vertices, 8U);
  EXPECT_EQ(found.triangles, 12U);
  EXPECT_EQ(found.edges, 18U);
  EXPECT_EQ(found.components, 1U);
  EXPECT_DOUBLE_EQ(found.area, 6);
  EXPECT_DOUBLE_EQ(found.diagonal, std::sqrt(3));
  EXPECT_EQ(found.boundary_edges + found.non_manifold_edges + found.inconsistent_edges, 0U);
  EXPECT_EQ(found.boundary_length, 0);
  EXPECT_EQ(found.unreferenced_vertices + found.coincident_vertices, 0U);
  EXPECT_EQ(found.degenerate_triangles + found.duplicate_triangles, 0U);
}

TEST(Diagnose, FindsTheRimOfAnOpenCubeAsBoundary) {
  Shape open = cube();
  open.triangles = open.triangles.bottomRows(10).eval();
  const ShapeDiagnostics found = diagnose(open);
  EXPECT_FALSE(found.closed);
  EXPECT_EQ(found.boundary_edges, 4U);
  EXPECT_DOUBLE_EQ(found.boundary_length, 4);
  EXPECT_EQ(found.unreferenced_vertices, 0U);
  open.triangles = open.triangles.topRows(1).eval();
  EXPECT_EQ(diagnose(open).unreferenced_vertices, 5U);
  EXPECT_DOUBLE_EQ(diagnose(open).boundary_length, 2 + std::sqrt(2));
}

TEST(Diagnose, CountsInconsistentEdgesOfAReversedTriangle) {
  Shape shape = cube();
  std::swap(shape.triangles(3, 0), shape.triangles(3, 1));
  EXPECT_EQ(diagnose(shape).inconsistent_edges, 3U);
  EXPECT_TRUE(diagnose(shape).closed);
  EXPECT_EQ(diagnose(test::flipped(cube())).inconsistent_edges, 0U);
}

TEST(Diagnose, CountsPartsWithCoincidentVerticesAsOneComponent) {
  const auto two_cubes = [](double x, double y) {
    return test::joined({cube(), test::transformed(cube(), 1, Eigen::Matrix3d::Identity(), Eigen::Vector3d(x, y, 0))});
  };
  EXPECT_EQ(diagnose(two_cubes(3, 0)).components, 2U);
  EXPECT_EQ(diagnose(two_cubes(3, 0)).coincident_vertices, 0U);
  const ShapeDiagnostics touching = diagnose(two_cubes(1, 1));
  EXPECT_EQ(touching.components, 1U);
  EXPECT_EQ(touching.coincident_vertices, 2U);
  EXPECT_EQ(touching.non_manifold_edges, 1U) << "the common edge has four triangles";
  EXPECT_TRUE(touching.closed);
}

TEST(Diagnose, CountsAnEdgeOfThreeTrianglesAsNonManifold) {
  const Shape book{.vertices = Points{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}},
                   .triangles = Triangles{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  const ShapeDiagnostics found = diagnose(book);
  EXPECT_EQ(found.edges, 7U);
  EXPECT_EQ(found.non_manifold_edges, 1U);
  EXPECT_EQ(found.boundary_edges, 6U);
  EXPECT_FALSE(found.closed);
  EXPECT_EQ(found.components, 1U);
}

TEST(Diagnose, ReportsAMoebiusStripAsNonOrientable) {
  const ShapeDiagnostics found = diagnose(test::twisted_band(20, 1));
  EXPECT_EQ(found.boundary_edges, 40U);
  EXPECT_EQ(found.inconsistent_edges, 1U);
  EXPECT_EQ(found.non_manifold_edges, 0U);
  EXPECT_EQ(found.edges, 80U) << "Euler characteristic 40 - 80 + 40 = 0";
}

TEST(Diagnose, ReportsAMeshWithAnInnerWallAsClosedButNonManifold) {
  // Two tetrahedra glued at a face; if that face remains, its edges have three triangles each.
  const Shape pair{.vertices = Points{{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                   .triangles = Triangles{{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}};
  EXPECT_TRUE(diagnose(pair).closed);
  EXPECT_TRUE(is_closed(pair));
  const Shape walled = with_triangle(pair, 0, 1, 2);
  const ShapeDiagnostics found = diagnose(walled);
  EXPECT_FALSE(found.closed);
  EXPECT_FALSE(is_closed(walled));
  EXPECT_FALSE(is_closed_and_oriented(walled));
  EXPECT_EQ(found.boundary_edges, 0U);
  EXPECT_EQ(found.non_manifold_edges, 3U);
  EXPECT_FALSE(diagnose(with_triangle(walled, 2, 1, 0)).closed) << "a double does not make the number even";
}

TEST(Diagnose, CountsDegenerateAndDuplicateTriangles) {
  EXPECT_EQ(diagnose(with_triangle(cube(), 0, 0, 1)).degenerate_triangles, 1U);
  EXPECT_TRUE(diagnose(with_triangle(cube(), 0, 0, 1)).closed);
  Shape needle = cube();
  needle.vertices.conservativeResize(9, Eigen::NoChange);
  needle.vertices.row(8) << 0.5, 0, 0;
  EXPECT_EQ(diagnose(with_triangle(needle, 0, 8, 1)).degenerate_triangles, 1U);
  needle.vertices.row(8) << 0.5, 1e-9, 0;
  EXPECT_EQ(diagnose(with_triangle(needle, 0, 8, 1)).degenerate_triangles, 0U);
  const Shape twice = with_triangle(with_triangle(cube(), 2, 1, 0), 4, 5, 6);
  EXPECT_EQ(diagnose(twice).duplicate_triangles, 2U);
  EXPECT_EQ(diagnose(twice).non_manifold_edges, 0U) << "doubles have no edges of their own";
  EXPECT_TRUE(diagnose(twice).closed);
}

TEST(Diagnose, GivesTheSameCountsForAnyTriangleOrderAndMeshSize) {
  const Shape broken = with_triangle(
      with_triangle(test::joined({test::torus(3, 1, 12, 8), test::sphere(1, 1), test::twisted_band(9, 1)}), 0, 1, 2), 5,
      5, 9);
  const ShapeDiagnostics found = diagnose(broken);
  EXPECT_EQ(found.closed, is_closed(broken));
  for (unsigned seed = 0; seed < 10; ++seed) {
    Shape other = test::permuted(broken, seed).shape;
    other.vertices *= 0x1p100;
    const ShapeDiagnostics again = diagnose(other);
    EXPECT_EQ(again.components, found.components);
    EXPECT_EQ(again.edges, found.edges);
    EXPECT_EQ(again.boundary_edges, found.boundary_edges);
    EXPECT_EQ(again.boundary_length, found.boundary_length * 0x1p100);
    EXPECT_EQ(again.non_manifold_edges, found.non_manifold_edges);
    EXPECT_EQ(again.inconsistent_edges, found.inconsistent_edges);
    EXPECT_EQ(again.degenerate_triangles, found.degenerate_triangles);
    EXPECT_EQ(again.duplicate_triangles, found.duplicate_triangles);
    EXPECT_EQ(again.closed, found.closed);
  }
}

TEST(Diagnose, CountsOnlyThePointsOfACloud) {
  const Shape cloud{.vertices = Points{{0, 0, 0}, {3, 4, 0}, {0, 0, 0}}, .triangles = {}};
  const ShapeDiagnostics found = diagnose(cloud);
  EXPECT_EQ(found.vertices, 3U);
  EXPECT_EQ(found.coincident_vertices, 1U);
  EXPECT_EQ(found.unreferenced_vertices, 0U);
  EXPECT_DOUBLE_EQ(found.diagonal, 5);
  EXPECT_EQ(found.triangles + found.components + found.edges, 0U);
  EXPECT_FALSE(found.closed);
  EXPECT_EQ(diagnose(Shape{}).vertices, 0U);
}

}  // namespace

}  // namespace shapegauge

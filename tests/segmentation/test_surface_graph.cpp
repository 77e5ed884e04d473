#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <set>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/segmentation/surface_graph.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Two squares, each of two triangles, that meet in the y axis at an angle: the second rises by `slope` to the right.
Shape valley(double slope) {
  Shape shape;
  shape.vertices.resize(6, 3);
  shape.vertices << 0, 0, 0, 0, 1, 0, -1, 0, 0, -1, 1, 0, 1, 0, slope, 1, 1, slope;
  shape.triangles.resize(4, 3);
  shape.triangles << 0, 1, 2, 2, 1, 3, 0, 4, 1, 4, 5, 1;
  return shape;
}

double concavity(const SurfaceGraph& graph, std::int32_t from, std::int32_t to) {
  for (const SurfaceLink& link : graph.links_of(from)) {
    if (link.to == to) return link.concavity;
  }
  ADD_FAILURE() << from << " and " << to << " are no neighbours";
  return 0;
}

TEST(SurfaceGraph, AValleyIsConcaveAndARidgeConvex) {
  const double angle = std::atan(0.5);
  EXPECT_NEAR(concavity(surface_graph(valley(0.5)), 0, 2), angle, 1e-12);
  EXPECT_NEAR(concavity(surface_graph(valley(-0.5)), 0, 2), -angle, 1e-12);
  EXPECT_NEAR(concavity(surface_graph(valley(0.5)), 0, 1), 0, 1e-12);
}

TEST(SurfaceGraph, TrianglesTurnedOverAreComparedAsIfTheyWereNot) {
  Shape shape = valley(0.5);
  std::swap(shape.triangles(2, 0), shape.triangles(2, 1));
  EXPECT_NEAR(concavity(surface_graph(shape), 0, 2), std::atan(0.5), 1e-12);
}

TEST(SurfaceGraph, ALinkKnowsItsEdge) {
  const SurfaceGraph graph = surface_graph(valley(0));
  for (const SurfaceLink& link : graph.links_of(0)) {
    EXPECT_DOUBLE_EQ(link.length, link.to == 2 ? 1 : std::numbers::sqrt2);
    if (link.to != 1) continue;
    EXPECT_DOUBLE_EQ(link.distance, 2 * std::hypot(1 / 6.0, 1 / 6.0));
  }
}

TEST(SurfaceGraph, EveryLinkHasItsReverse) {
  for (const Shape& shape : {test::sphere(1, 2), test::soup(test::box({1, 2, 3}, 2)),
                             Shape{.vertices = test::torus(2, 1, 12, 20).vertices, .triangles = {}}}) {
    const SurfaceGraph graph = surface_graph(shape);
    std::set<std::pair<std::int32_t, std::int32_t>> links;
    for (std::int32_t i = 0; i < graph.size(); ++i) {
      for (const SurfaceLink& link : graph.links_of(i)) EXPECT_TRUE(links.emplace(i, link.to).second);
    }
    EXPECT_FALSE(links.empty());
    for (const auto& [from, to] : links) EXPECT_TRUE(links.contains({to, from}));
  }
}

TEST(SurfaceGraph, OfAClosedMeshHasThreeNeighboursEach) {
  const SurfaceGraph graph = surface_graph(test::soup(test::sphere(1, 2)));
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    EXPECT_EQ(graph.links_of(i).size(), 3U);
    for (const SurfaceLink& link : graph.links_of(i)) EXPECT_LT(link.concavity, 0);
  }
}

TEST(SurfaceGraph, TrianglesAtAnEdgeOfManyAreLinkedInARow) {
  Shape fan;
  fan.vertices.resize(5, 3);
  fan.vertices << 0, 0, 0, 0, 0, 1, 1, 0, 0, -1, 1, 0, -1, -1, 0;
  fan.triangles.resize(3, 3);
  fan.triangles << 0, 1, 2, 0, 1, 3, 0, 1, 4;
  const SurfaceGraph graph = surface_graph(fan);
  EXPECT_EQ(graph.links_of(0).size(), 1U);
  EXPECT_EQ(graph.links_of(1).size(), 2U);
  EXPECT_EQ(graph.links_of(2).size(), 1U);
}

TEST(SurfaceGraph, RefusesAnEmptyShape) { EXPECT_THROW(surface_graph(Shape{}), InputError); }

}  // namespace
}  // namespace shapegauge

#include <gmock/gmock.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/preparation/vertex_neighbours.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::IsEmpty;

TEST(VertexNeighbours, OfTwoTrianglesAndAVertexOfNone) {
  Shape shape;
  shape.vertices.resize(5, 3);
  shape.vertices << 0, 0, 0, 1, 0, 0, 9, 9, 9, 1, 1, 0, 0, 1, 0;
  shape.triangles.resize(2, 3);
  shape.triangles << 0, 1, 3, 4, 3, 0;
  const VertexNeighbours neighbours = vertex_neighbours(shape);
  EXPECT_THAT(neighbours.of(0), ElementsAre(1, 3, 4));
  EXPECT_THAT(neighbours.of(1), ElementsAre(0, 3));
  EXPECT_THAT(neighbours.of(2), IsEmpty());
  EXPECT_THAT(neighbours.of(3), ElementsAre(0, 1, 4));
  EXPECT_THAT(neighbours.of(4), ElementsAre(0, 3));
}

TEST(VertexNeighbours, OfATorusAreSixEach) {
  const Shape torus = test_shapes::torus(2, 0.7, 8, 12);
  const VertexNeighbours neighbours = vertex_neighbours(torus);
  for (Eigen::Index v = 0; v < torus.vertices.rows(); ++v) EXPECT_EQ(neighbours.of(v).size(), 6U) << v;
}

TEST(VertexNeighbours, OfASoupAreThoseOfItsMesh) {
  const Shape torus = test_shapes::torus(2, 0.7, 8, 12);
  const Shape soup = test_shapes::soup(torus);
  const VertexNeighbours expected = vertex_neighbours(torus);
  const VertexNeighbours found = vertex_neighbours(soup);
  for (Eigen::Index v = 0; v < soup.vertices.rows(); ++v) {
    std::vector<std::int32_t> places;  // the neighbours by the mesh's indices
    for (const std::int32_t u : found.of(v)) places.push_back(torus.triangles(u / 3, u % 3));
    std::ranges::sort(places);
    EXPECT_THAT(places, ElementsAreArray(expected.of(torus.triangles(v / 3, v % 3)))) << v;
  }
}

TEST(VertexNeighbours, OfACloudOrOfNothingAreNone) {
  const Shape cloud{test_shapes::sphere(1, 1).vertices, {}};
  const VertexNeighbours neighbours = vertex_neighbours(cloud);
  for (Eigen::Index v = 0; v < cloud.vertices.rows(); ++v) EXPECT_THAT(neighbours.of(v), IsEmpty());
  EXPECT_THAT(vertex_neighbours({}).neighbours, IsEmpty());
}

TEST(VertexNeighbours, RefusesATriangleWithoutVertices) {
  Shape shape = test_shapes::sphere(1, 0);
  shape.triangles(3, 1) = 12;
  EXPECT_THROW(vertex_neighbours(shape), InputError);
}

}  // namespace
}  // namespace shapegauge

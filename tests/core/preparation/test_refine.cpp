#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/preparation/refine.h"
#include "shapegauge/core/shape/connectivity.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

double longest_edge(const Shape& shape) {
  double longest = 0;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto from = shape.vertices.row(shape.triangles(f, k));
      longest = std::max(longest, (shape.vertices.row(shape.triangles(f, (k + 1) % 3)) - from).norm());
    }
  }
  return longest;
}

TEST(Refined, HasNoLongEdgesAndTheSameSurface) {
  for (const Shape& shape :
       {test::box({1, 2, 3}, 1), test::capsule(0.2, 3, 12, 6), test::soup(test::box({1, 2, 3}, 1))}) {
    const Shape fine = refined(shape, {.longest_edge = 0.1});
    EXPECT_LE(longest_edge(fine), 0.1 * std::sqrt(surface_area(shape)));
    EXPECT_NEAR(surface_area(fine), surface_area(shape), 1e-9);
    EXPECT_NEAR(test::signed_volume(fine), test::signed_volume(shape), 1e-9);
    EXPECT_EQ(fine.vertices.topRows(shape.vertices.rows()), shape.vertices);
  }
}

TEST(Refined, ClosedMeshesStayClosed) {
  const Shape box = test::box({1, 2, 3}, 1);
  for (const double edge : {0.5, 0.2, 0.07}) EXPECT_TRUE(is_watertight(refined(box, {.longest_edge = edge}))) << edge;
  EXPECT_TRUE(is_watertight(refined(test::soup(box), {.longest_edge = 0.2})));
}

TEST(Refined, LongThinTrianglesAreCutAcross) {
  Shape strip;
  strip.vertices.resize(3, 3);
  strip.vertices << 0, 0, 0, 100, 0, 0, 0, 0.01, 0;
  strip.triangles.resize(1, 3);
  strip.triangles << 0, 1, 2;
  const double root = std::sqrt(0.5);
  const Shape fine = refined(strip, {.longest_edge = 1 / root});
  EXPECT_LE(longest_edge(fine), 1);
  EXPECT_LT(fine.triangles.rows(), 600);
}

TEST(Refined, FineMeshesAndCloudsStayAsTheyAre) {
  const Shape ball = test::sphere(1, 3);
  EXPECT_EQ(refined(ball, {.longest_edge = 1}).triangles, ball.triangles);
  const Shape cloud{ball.vertices, {}};
  EXPECT_EQ(refined(cloud).vertices, cloud.vertices);
}

TEST(Refined, EndsBeforeThereAreTooManyVertices) {
  const Shape box = test::box({1, 2, 3}, 1);
  const Shape fine = refined(box, {.longest_edge = 0.001, .most_vertices = 1000});
  EXPECT_LE(fine.vertices.rows(), 1000);
  EXPECT_GT(fine.vertices.rows(), 250);
  EXPECT_TRUE(is_watertight(fine));
}

TEST(Refined, RefusesOptionsOutOfRange) {
  const Shape box = test::box({1, 2, 3}, 1);
  EXPECT_THROW(refined(box, {.longest_edge = 0}), InputError);
  EXPECT_THROW(refined(box, {.longest_edge = std::nan("")}), InputError);
  EXPECT_THROW(refined(box, {.most_vertices = 2}), InputError);
}

}  // namespace
}  // namespace shapegauge

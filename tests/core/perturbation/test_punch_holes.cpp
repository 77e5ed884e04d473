#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/error.h"
#include "shapegauge/core/perturbation/punch_holes.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

Shape punched(const Shape& shape, const PunchHolesOptions& options, std::uint64_t seed) {
  RandomNumbers random(seed);
  return punch_holes(shape, options, random);
}

TEST(PunchHoles, AHoleInASphereIsACapOfItsRadius) {
  const Shape sphere = test_shapes::sphere(1, 6);
  const double radius = 0.1 * bounding_box_diagonal(sphere);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const double lost = surface_area(sphere) - surface_area(punched(sphere, {.number = 1, .radius = 0.1}, seed));
    // Within a chord c of a point on a sphere is a cap of area pi c^2; its rim is as ragged as a triangle is long.
    EXPECT_NEAR(lost / (std::numbers::pi * radius * radius), 1, 0.02) << seed;
  }
}

TEST(PunchHoles, HolesAddUpAndDependOnTheSeed) {
  const Shape sphere = test_shapes::sphere(1, 4);
  EXPECT_EQ(punched(sphere, {.number = 0}, 1).triangles, sphere.triangles);
  const Eigen::Index one = punched(sphere, {.number = 1}, 1).triangles.rows();
  const Eigen::Index five = punched(sphere, {.number = 5}, 1).triangles.rows();
  EXPECT_LT(one, sphere.triangles.rows());
  EXPECT_LT(five, one);
  EXPECT_EQ(punched(sphere, {}, 1).triangles, punched(sphere, {}, 1).triangles);
  const Triangles first = punched(sphere, {}, 1).triangles;
  const Triangles second = punched(sphere, {}, 2).triangles;
  EXPECT_TRUE(first.rows() != second.rows() || first != second);
}

TEST(PunchHoles, RemovesPointsOfACloudAboutSomeOfThem) {
  Shape cloud;
  cloud.vertices = test_shapes::sphere(1, 3).vertices;
  const Shape rest = punched(cloud, {.number = 3, .radius = 0}, 1);
  EXPECT_EQ(rest.vertices.rows(), cloud.vertices.rows() - 3);
}

TEST(PunchHoles, RefusesToLeaveNothingAndOptionsOutOfRange) {
  const Shape box = test_shapes::box({1, 1, 1}, 2);
  EXPECT_THROW(punched(box, {.number = 1, .radius = 2}, 1), InputError);
  EXPECT_THROW(punched(box, {.number = -1}, 1), InputError);
  EXPECT_THROW(punched(box, {.radius = -1}, 1), InputError);
  EXPECT_THROW(punched(Shape{}, {}, 1), InputError);
  Shape needle;
  needle.vertices.resize(2, 3);
  needle.vertices << 0, 0, 0, 1, 0, 0;
  needle.triangles.resize(1, 3);
  needle.triangles << 0, 1, 1;
  EXPECT_THROW(punched(needle, {}, 1), InputError);
}

}  // namespace
}  // namespace shapegauge

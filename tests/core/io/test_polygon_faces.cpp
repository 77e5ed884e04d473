// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/triangulate_polygon.h"
#include "shapegauge/core/shape/polygons.h"
#include "shapegauge/core/shape/shape.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

using Corners = std::vector<Eigen::Vector3d>;

/// A U: a rectangle of 10 by 5 with a slot of 4 by 4.5.
Corners u_profile() {
  return {{0, 0, 0}, {10, 0, 0}, {10, 5, 0}, {7, 5, 0}, {7, 0.5, 0}, {3, 0.5, 0}, {3, 5, 0}, {0, 5, 0}};
}
constexpr double area_of_u = 10 * 5 - 4 * 4.5;

Corners regular(int corners) {
  Corners polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    polygon.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  return polygon;
}

/// Star about the origin; every second corner is near the centre.
Corners star(int corners, double inner) {
  Corners polygon = regular(corners);
  for (std::size_t i = 1; i < polygon.size(); i += 2) polygon[i] *= inner;
  return polygon;
}

/// OBJ file with one face.
std::string obj_of(const Corners& corners) {
  std::string text;
  for (const Eigen::Vector3d& corner : corners) text += fmt::format("v {} {} {}\n", corner[0], corner[1], corner[2]);
  text += "f";
  for (std::size_t i = 0; i < corners.size(); ++i) text += fmt::format(" {}", i + 1);
  return text + "\n";
}

Shape read(const Corners& corners) { return read_obj(obj_of(corners), "shape"); }

std::vector<std::array<std::int32_t, 3>> triangles_of(const Shape& shape) {
  std::vector<std::array<std::int32_t, 3>> triangles;
  for (const auto& row : shape.triangles.rowwise()) triangles.push_back({row[0], row[1], row[2]});
  return triangles;
}

std::vector<std::array<std::int32_t, 3>> fan(std::int32_t corners) {
  std::vector<std::array<std::int32_t, 3>> triangles;
  for (std::int32_t i = 2; i < corners; ++i) triangles.push_back({0, i - 1, i});
  return triangles;
}

/// Sum of the triangles' signed areas in the xy plane.
double signed_area(const Shape& shape) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles_of(shape)) {
    const Eigen::Vector3d side = shape.vertices.row(b) - shape.vertices.row(a);
    const Eigen::Vector3d other = shape.vertices.row(c) - shape.vertices.row(a);
    sum += side.cross(other).z() / 2;
  }
  return sum;
}

/// Checks that triangles are oriented as the polygon and that their areas add up to its area, which excludes overlaps.
void expect_covered(const Corners& corners, double area) {
  const Shape shape = read(corners);
  EXPECT_NEAR(surface_area(shape), area, 1e-9 * area);
  EXPECT_NEAR(signed_area(shape), area, 1e-9 * area);
}

TEST(PolygonTriangulation, CoversConcavePolygonsWithoutOverlaps) {
  expect_covered(u_profile(), area_of_u);
  EXPECT_EQ(read(u_profile()).triangles.rows(), 6);
  expect_covered({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}, 4);  // an arrowhead
  expect_covered(star(10, 0.3), 10 * 0.5 * 0.3 * std::sin(2 * std::numbers::pi / 10));
  for (std::size_t first = 0; first < u_profile().size(); ++first) {
    Corners turned = u_profile();
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
    expect_covered(turned, area_of_u);
  }
}

TEST(PolygonTriangulation, CoversAPolygonWithAnInwardEdgeWithoutOverlaps) {
  // A square whose last corner but one is inside it: the fan about the first corner folds over.
  const Corners square = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 4, 0}, {2, 1, 0}, {2, 4, 0}, {0, 4, 0}};
  expect_covered(square, 16);
  const std::vector<std::array<std::int32_t, 3>> triangles = triangles_of(read(square));
  EXPECT_TRUE(std::ranges::any_of(triangles, [](const auto& corners) { return std::ranges::count(corners, 4) == 1; }))
      << "the corner inside is a corner of triangles";
  // From a side that ends inside to one below it: one triangle more than the fan.
  const Corners kite = {{16, 31, 0}, {-3, 0, 0}, {0, -6, 0}, {0, 0, 0}, {0, -22, 0}};
  expect_covered(kite, 231.5);
  EXPECT_EQ(read(kite).triangles.rows(), 4);
}

TEST(PolygonTriangulation, KeepsTheOrientationOfConcavePolygons) {
  Corners turned = u_profile();
  std::ranges::reverse(turned);
  EXPECT_NEAR(signed_area(read(turned)), -area_of_u, 1e-9);
}

TEST(PolygonTriangulation, DoesNotDependOnTheSizeAndPlaneOfThePolygon) {
  const auto expected = triangles_of(read(u_profile()));
  EXPECT_NE(expected, fan(8));
  for (const double scale : {1e-300, 1e-9, 1e9, 1e300}) {
    Corners scaled = u_profile();
    for (Eigen::Vector3d& corner : scaled) corner *= scale;
    EXPECT_EQ(triangles_of(read(scaled)), expected) << scale;
  }
  Corners standing = u_profile();
  for (Eigen::Vector3d& corner : standing) corner = {corner.y(), 100, corner.x()};
  EXPECT_EQ(triangles_of(read(standing)), expected);
}

TEST(PolygonTriangulation, SplitsConvexPolygonsIntoFans) {
  EXPECT_THAT(triangles_of(read(regular(4))), ElementsAre(std::array{0, 1, 2}, std::array{0, 2, 3}));
  EXPECT_EQ(triangles_of(read(regular(300))), fan(300));
  EXPECT_EQ(triangles_of(read({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}})), fan(5))
      << "a corner on a side";
  EXPECT_EQ(triangles_of(read({{0, 0, 0}, {1, 0, 0.3}, {1, 1, 0}, {0, 1, 0.3}})), fan(4)) << "a saddle";
}

TEST(PolygonTriangulation, CoversNearlyPlanarConcavePolygons) {
  Corners bent = u_profile();
  for (std::size_t i = 0; i < bent.size(); ++i) bent[i].z() = i % 2 == 0 ? 0.05 : 0;
  const Shape shape = read(bent);
  EXPECT_NEAR(signed_area(shape), area_of_u, 1e-9);
  EXPECT_NEAR(surface_area(shape), area_of_u, 0.01 * area_of_u);
}

TEST(PolygonTriangulation, ExcludesAHoleConnectedToTheOutlineByABridge) {
  const Corners frame = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                         {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  expect_covered(frame, 12);
}

TEST(PolygonTriangulation, CoversPolygonsThatTouchThemselves) {
  // Two diamonds with a common corner; another corner lies on a side of the first.
  expect_covered({{0, 0, 0}, {2, -2, 0}, {4, 0, 0}, {6, -2, 0}, {8, 0, 0}, {6, 2, 0}, {4, 0, 0}, {2, 2, 0}}, 16);
  // A corner on the opposite side.
  expect_covered({{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 0, 0}, {0, 2, 0}}, 4);
}

TEST(PolygonTriangulation, SplitsSelfIntersectingPolygonsIntoFans) {
  EXPECT_EQ(triangles_of(read({{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 1, 0}})), fan(4)) << "a bow";
  EXPECT_EQ(triangles_of(read({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}})), fan(4)) << "without area";
  EXPECT_EQ(triangles_of(read({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}, {5, 5, 5}})), fan(5)) << "a line";
  EXPECT_EQ(triangles_of(read({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}})), fan(4)) << "a point";
  const Corners five = regular(5);
  EXPECT_EQ(triangles_of(read({five[0], five[2], five[4], five[1], five[3]})), fan(5)) << "a pentagram";
}

TEST(PolygonTriangulation, IsTheSameInEveryFileFormat) {
  std::string off = "OFF\n8 1 0\n";
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\n";
  ply += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Eigen::Vector3d& corner : u_profile()) {
    off += fmt::format("{} {} {}\n", corner[0], corner[1], corner[2]);
    ply += fmt::format("{} {} {}\n", corner[0], corner[1], corner[2]);
  }
  const auto expected = triangles_of(read(u_profile()));
  EXPECT_EQ(triangles_of(read_off(off + "8 0 1 2 3 4 5 6 7\n", "shape")), expected);
  EXPECT_EQ(triangles_of(read_ply(ply + "8 0 1 2 3 4 5 6 7\n", "shape")), expected);
}

TEST(PolygonTriangulation, RecordsThePolygonOfEachTriangleUnlessAllFacesAreTriangles) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const Shape triangles = read_obj(vertices + "f 1 2 3\nf 1 3 4\n", "shape");
  EXPECT_FALSE(has_polygons(triangles));
  EXPECT_EQ(polygon_count(triangles), 2);
  EXPECT_EQ(polygon_of(triangles, 1), 1);

  const Shape mixed = read_obj(vertices + "f 1 2 3\nf 1 2 3 4\nf 1 2\nf 1 3 4\nf 2\n", "shape");
  EXPECT_THAT(mixed.polygons.of_triangle, ElementsAre(0, 1, 1, 3));
  EXPECT_EQ(polygon_count(mixed), 5);

  const Shape flawed_first = read_obj(vertices + "f 2\nf 1 2 3\nf 1 3 4\n", "shape");
  EXPECT_THAT(flawed_first.polygons.of_triangle, ElementsAre(1, 2));
  EXPECT_EQ(polygon_count(flawed_first), 3);

  const Shape flawed = read_obj(vertices + "f 1 2 3\nf 2\n", "shape");
  EXPECT_THAT(flawed.polygons.of_triangle, ElementsAre(0));
  EXPECT_EQ(polygon_count(flawed), 2);
}

TEST(PolygonTriangulation, AcceptsTheMaximumNumberOfCornersAndRejectsMore) {
  const int most = static_cast<int>(max_polygon_corners);
  const Shape shape = read(star(most, 0.9));
  EXPECT_EQ(shape.triangles.rows(), most - 2);
  EXPECT_NEAR(surface_area(shape), most * 0.5 * 0.9 * std::sin(2 * std::numbers::pi / most), 1e-9);

  std::string corners;
  for (std::size_t i = 0; i <= max_polygon_corners; ++i) corners += " 1";
  const std::string count = fmt::format("{}", max_polygon_corners + 1);
  const auto too_many = AllOf(HasSubstr("face "), HasSubstr("100000"));
  EXPECT_THAT(test::input_error_of([&] { read_obj("v 0 0 0\nf" + corners + "\n", "shape"); }), too_many);
  EXPECT_THAT(test::input_error_of([&] { read_off("OFF\n1 1 0\n0 0 0\n" + count + corners, "shape"); }), too_many);
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uint int vertex_indices\nend_header\n0 0 0\n0 0 0\n";
  EXPECT_THAT(test::input_error_of([&] { read_ply(ply + count + corners + "\n", "shape"); }), too_many);
}

TEST(PolygonTriangulation, CoversPolygonsWithThousandsOfCoincidentCorners) {
  constexpr int petals = 20000;
  Corners polygon;
  double area = 0;
  for (int i = 0; i < petals; ++i) {
    const double angle = 2 * std::numbers::pi * i / petals;
    const double radius = 1 + 0.01 * (i * 7 % 13);
    polygon.emplace_back(0, 0, 0);
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    polygon.emplace_back(radius * std::cos(angle + 1e-4), radius * std::sin(angle + 1e-4), 0);
    area += radius * radius / 2 * std::sin(1e-4);
  }
  std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  expect_covered(polygon, area);
}

}  // namespace

}  // namespace shapegauge

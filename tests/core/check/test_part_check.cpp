// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/check/part_check.h"
#include "shapegauge/core/shape/connectivity.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using Breaks = std::vector<double>;

constexpr double wall_limit = 1.2;
constexpr double gap_limit = 0.5;

/// Returns the breaks with each interval divided into n.
Breaks divided(const Breaks& breaks, int n) {
  Breaks result{breaks.front()};
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    for (int k = 1; k <= n; ++k) result.push_back(breaks[i - 1] + (breaks[i] - breaks[i - 1]) * k / n);
  }
  return result;
}

/// Returns the surface of the cells of a grid whose centres are in the solid. Each interval of the grid is divided into
/// n.
Shape grid_solid(const std::array<Breaks, 3>& breaks, int n, const std::function<bool(const Eigen::Vector3d&)>& solid) {
  std::array<Breaks, 3> grid;
  for (std::size_t k = 0; k < 3; ++k) grid[k] = divided(breaks[k], n);
  const auto at = [&](const std::array<int, 3>& i) -> Eigen::Vector3d {
    return {grid[0][static_cast<std::size_t>(i[0])], grid[1][static_cast<std::size_t>(i[1])],
            grid[2][static_cast<std::size_t>(i[2])]};
  };
  const auto filled = [&](const std::array<int, 3>& cell) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (cell[k] < 0 || cell[k] + 1 >= std::ssize(grid[k])) return false;
    }
    return solid((at(cell) + at({cell[0] + 1, cell[1] + 1, cell[2] + 1})) / 2);
  };
  std::vector<Eigen::Vector3d> corners;
  const auto add_side = [&](std::array<int, 3> cell, std::size_t axis, bool upper) {
    if (upper) ++cell[axis];
    std::array<std::array<int, 3>, 4> square{cell, cell, cell, cell};
    for (const int k : {1, 2}) ++square[static_cast<std::size_t>(k)][(axis + 1) % 3];
    for (const int k : {2, 3}) ++square[static_cast<std::size_t>(k)][(axis + 2) % 3];
    if (!upper) std::swap(square[1], square[3]);
    for (const std::size_t k : {0U, 1U, 2U, 0U, 2U, 3U}) corners.push_back(at(square[k]));
  };
  for (int x = 0; x + 1 < std::ssize(grid[0]); ++x) {
    for (int y = 0; y + 1 < std::ssize(grid[1]); ++y) {
      for (int z = 0; z + 1 < std::ssize(grid[2]); ++z) {
        const std::array<int, 3> cell{x, y, z};
        if (!filled(cell)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (const int step : {-1, 1}) {
            std::array<int, 3> next = cell;
            next[axis] += step;
            if (!filled(next)) add_side(cell, axis, step > 0);
          }
        }
      }
    }
  }
  return test::soup_of(corners);
}

bool everywhere(const Eigen::Vector3d& /*point*/) { return true; }

Shape block(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int n) {
  return grid_solid({Breaks{low[0], high[0]}, Breaks{low[1], high[1]}, Breaks{low[2], high[2]}}, n, everywhere);
}

/// Tube along z from 0 to 10: N-gons of radius `outer` about the origin and `inner` about (shift, 0).
Shape tube(double outer, double inner, double shift, int sides) {
  Shape shape;
  shape.vertices.resize(4 * sides, 3);
  shape.triangles.resize(8 * sides, 3);
  for (int i = 0; i < sides; ++i) {
    const double angle = (2 * i + 1) * std::numbers::pi / sides;
    const Eigen::RowVector3d direction(std::cos(angle), std::sin(angle), 0);
    const Eigen::RowVector3d top(0, 0, 10);
    shape.vertices.row(4 * i) = outer * direction;
    shape.vertices.row(4 * i + 1) = outer * direction + top;
    shape.vertices.row(4 * i + 2) = inner * direction + Eigen::RowVector3d(shift, 0, 10);
    shape.vertices.row(4 * i + 3) = inner * direction + Eigen::RowVector3d(shift, 0, 0);
    for (int k = 0; k < 4; ++k) {
      const int here = 4 * i + k;
      const int up = 4 * i + (k + 1) % 4;
      const int side = (here + 4) % (4 * sides);
      const int both = (up + 4) % (4 * sides);
      shape.triangles.row(2 * here) << here, side, both;
      shape.triangles.row(2 * here + 1) << here, both, up;
    }
  }
  return shape;
}

/// Expected region: `distance` is that of a point to the region in which the minimum may be.
struct Expected {
  double area;
  double minimum;
  std::function<double(const Eigen::Vector3d&)> distance;
};

struct Part {
  std::string name;
  std::function<Shape(int resolution)> shape;  ///< 0, 1 or 2
  CheckOptions limits;
  std::vector<Expected> regions;  ///< largest first
  bool curved = false;            ///< regular facets: other meshes of the same surface are not made from it
};

int intervals(int resolution) { return resolution == 0 ? 1 : 4 * resolution - 1; }

Part plate() {
  const auto on_a_side = [](const Eigen::Vector3d& p) { return std::abs(std::abs(p.z()) - 0.5); };
  return {"plate",
          [](int r) {
            return block({-10, -6, -0.5}, {10, 6, 0.5}, intervals(r));
          },
          {.min_wall = wall_limit},
          {{240, 1, on_a_side}, {240, 1, on_a_side}}};
}

/// Wedge of 12 degrees without its tip. Its other edges are no sharper than 78 degrees.
Part wedge() {
  const double angle = std::numbers::pi / 15;
  const double slope = std::tan(angle);
  const double reach = wall_limit / (2 * std::tan(angle / 2));
  const double top_end = 4 / std::cos(angle);
  const auto to_line = [](double z) {
    return [z](const Eigen::Vector3d& p) { return std::hypot(p.x() - 4, p.z() - z); };
  };
  return {"wedge",
          [slope](int r) {
            Shape shape = block({4, 0, 0}, {14, 6, 1}, intervals(r));
            for (auto vertex : shape.vertices.rowwise()) vertex.z() *= slope * vertex.x();
            return shape;
          },
          {.min_wall = wall_limit},
          {{6 * (reach - 4), 4 * slope, to_line(0)},
           {6 * (reach - top_end), top_end * wall_limit / reach, to_line(4 * slope)}}};
}

/// Distance from the edge of a wall of thickness 1 at which the ball that touches the edge has the limit as diameter.
double beyond_an_edge() { return std::sqrt(wall_limit - 1); }

Part stepped_plate() {
  const auto at_height = [](double z) {
    return [z](const Eigen::Vector3d& p) { return std::abs(p.z() - z) + std::max(0.0, p.x() - 8); };
  };
  return {"stepped plate",
          [](int r) {
            return grid_solid({Breaks{0, 8, 20}, Breaks{0, 10}, Breaks{0, 1, 3}}, intervals(r),
                              [](const Eigen::Vector3d& p) { return p.x() > 8 || p.z() < 1; });
          },
          {.min_wall = wall_limit},
          {{10 * (8 + beyond_an_edge()), 1, at_height(0)}, {80, 1, at_height(1)}}};
}

Part centred_tube() {
  const auto on = [](double radius) {
    return [radius](const Eigen::Vector3d& p) { return std::abs(p.head<2>().norm() - radius); };
  };
  return {"tube",
          [](int r) { return tube(5, 4, 0, 48 << r); },
          {.min_wall = wall_limit},
          {{100 * std::numbers::pi, 1, on(5)}, {80 * std::numbers::pi, 1, on(4)}},
          true};
}

Part eccentric_tube() {
  // The ball between two circles, from a point of either.
  const double outer = std::acos((36 + 1 - 16 - 10 * wall_limit) / (12 - wall_limit));
  const double inner = std::acos((36 - 16 - 1 - 10 * wall_limit) / (8 + wall_limit));
  const auto to_line = [](double x) { return [x](const Eigen::Vector3d& p) { return std::hypot(p.x() - x, p.y()); }; };
  return {"eccentric tube",
          [](int r) { return tube(6, 4, 1, 128 << r); },
          {.min_wall = wall_limit},
          {{2 * outer * 6 * 10, 1, to_line(6)}, {2 * inner * 4 * 10, 1, to_line(5)}},
          true};
}

Part box_with_rib() {
  const auto on_a_side = [](const Eigen::Vector3d& p) {
    return std::abs(std::abs(p.x() - 9.5) - 0.5) + std::max(0.0, 4 - p.z());
  };
  return {"box with rib",
          [](int r) {
            return grid_solid({Breaks{0, 9, 10, 20}, Breaks{0, 12}, Breaks{0, 4, 7}}, intervals(r),
                              [](const Eigen::Vector3d& p) { return p.z() < 4 || std::abs(p.x() - 9.5) < 0.5; });
          },
          {.min_wall = wall_limit},
          {{36, 1, on_a_side}, {36, 1, on_a_side}}};
}

/// Twelve bars along the edges of a cube.
Part lattice() {
  const double d = beyond_an_edge();
  const double outer_faces = 6 * (4 * 8 + 4 * (2 * d - d * d));
  return {"lattice",
          [](int r) {
            const Breaks breaks{-5, -4, 4, 5};
            return grid_solid({breaks, breaks, breaks}, intervals(r),
                              [](const Eigen::Vector3d& p) { return (p.array().abs() > 4).count() >= 2; });
          },
          {.min_wall = wall_limit},
          {{outer_faces + 24 * 8, 1, [](const Eigen::Vector3d& p) {
              return std::min((p.array().abs() - 5).abs().minCoeff(), (p.array().abs() - 4).abs().minCoeff());
            }}}};
}

Part snap_fit() {
  const auto on_a_side = [](const Eigen::Vector3d& p) {
    return std::abs(std::abs(p.x() - 10) - 0.2) + std::max(0.0, 3 - p.z());
  };
  return {"snap-fit gap",
          [](int r) {
            return grid_solid({Breaks{0, 9.8, 10.2, 20}, Breaks{0, 10}, Breaks{0, 3, 8}}, intervals(r),
                              [](const Eigen::Vector3d& p) { return p.z() < 3 || std::abs(p.x() - 10) > 0.2; });
          },
          {.min_gap = gap_limit},
          {{50, 0.4, on_a_side}, {50, 0.4, on_a_side}}};
}

/// Plates that open by 15 degrees.
Part two_plates() {
  const double angle = std::numbers::pi / 12;
  const double width = 2 * std::tan(angle / 2);
  const double area = 6 * (gap_limit / width - 1);
  const auto to_ends = [angle](const Eigen::Vector3d& p) {
    return std::min(std::hypot(p.x() - 1, p.z()), std::hypot(p.x() - std::cos(angle), p.z() - std::sin(angle)));
  };
  return {"two plates",
          [angle](int r) {
            const Eigen::Matrix3d turn = Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
            const Shape upper = block({1, 0, 0}, {10, 6, 2}, intervals(r));
            return test::joined({block({1, 0, -2}, {10, 6, 0}, intervals(r)),
                                 test::transformed(upper, 1, turn, Eigen::Vector3d::Zero())});
          },
          {.min_gap = gap_limit},
          {{area, width, to_ends}, {area, width, to_ends}}};
}

/// Sphere of radius 5 with a void of radius 4 that is 0.3 out of its centre.
Part sphere_with_void() {
  const double outer = (25 + 0.09 - 16 - 9 * wall_limit) / (3 - 0.3 * wall_limit);
  const double inner = (25 - 16 - 0.09 - 9 * wall_limit) / (2.4 + 0.3 * wall_limit);
  const auto to_pole = [](double z) {
    return [z](const Eigen::Vector3d& p) { return (p - Eigen::Vector3d(0, 0, z)).norm(); };
  };
  return {"sphere with void",
          [](int r) {
            const Shape cavity = test::transformed(test::flipped(test::sphere(4, r == 1 ? 6 : 5)), 1,
                                                   Eigen::Matrix3d::Identity(), Eigen::Vector3d(0, 0, 0.3));
            return test::joined({test::sphere(5, r == 2 ? 6 : 5), cavity});
          },
          {.min_wall = wall_limit},
          {{50 * std::numbers::pi * (1 - outer), 0.7, to_pole(5)},
           {32 * std::numbers::pi * (1 - inner), 0.7, to_pole(4.3)}},
          true};
}

std::vector<Part> parts() {
  return {plate(),        wedge(),   stepped_plate(), centred_tube(), eccentric_tube(),
          box_with_rib(), lattice(), snap_fit(),      two_plates(),   sphere_with_void()};
}

/// Compares the regions of a mesh of the part, after undoing a rotation.
void expect_regions(const Part& part, const Shape& shape, const Eigen::Matrix3d& rotation, const std::string& what) {
  SCOPED_TRACE(part.name + ", " + what);
  const PartReport report = check_part(shape, part.limits);
  const ThinRegions& found = part.limits.min_wall > 0 ? report.walls : report.gaps;
  EXPECT_FALSE(report.passes());
  ASSERT_EQ(found.regions.size(), part.regions.size());
  const double size = bounding_box_diagonal(shape);
  for (std::size_t i = 0; i < found.regions.size(); ++i) {
    const ThinRegion& region = found.regions[i];
    const Expected& expected = part.regions[i];
    EXPECT_NEAR(region.area, expected.area, 0.01 * expected.area) << i;
    EXPECT_NEAR(region.minimum, expected.minimum, 0.01 * expected.minimum) << i;
    EXPECT_LE(expected.distance(rotation.transpose() * region.position), 0.01 * size) << i;
    EXPECT_NEAR((region.position - region.opposite).norm(), region.minimum, 0.03 * region.minimum) << i;
    EXPECT_GE(region.median, region.minimum) << i;
    EXPECT_LT(region.median, found.limit) << i;
    EXPECT_FALSE(region.is_edge) << i;
  }
}

TEST(PartCheck, FindsTheSameThinRegionsForAnyResolutionAndRotation) {
  for (const Part& part : parts()) {
    for (int resolution = 0; resolution < 3; ++resolution) {
      const Shape shape = part.shape(resolution);
      expect_regions(part, shape, Eigen::Matrix3d::Identity(), "resolution " + std::to_string(resolution));
      if (part.curved && resolution > 0) continue;
      const Eigen::Matrix3d turn = test::rotation(static_cast<unsigned>(resolution) + 1);
      expect_regions(part, test::transformed(shape, 1, turn, Eigen::Vector3d::Zero()), turn,
                     "turned, resolution " + std::to_string(resolution));
    }
  }
}

/// Halves every third triangle without its neighbours.
Shape with_t_junctions(const Shape& shape) {
  Shape result = test::soup(shape);
  const Eigen::Index count = shape.triangles.rows();
  std::vector<Eigen::RowVector3d> added;
  for (Eigen::Index f = 0; f < count; f += 3) {
    const Eigen::RowVector3d middle = (result.vertices.row(3 * f) + result.vertices.row(3 * f + 1)) / 2;
    added.insert(added.end(), {middle, result.vertices.row(3 * f + 1), result.vertices.row(3 * f + 2)});
    result.vertices.row(3 * f + 1) = middle;
  }
  result.vertices.conservativeResize(3 * count + std::ssize(added), 3);
  for (std::size_t i = 0; i < added.size(); ++i) {
    result.vertices.row(3 * count + static_cast<Eigen::Index>(i)) = added[i];
  }
  result.triangles.resize(result.vertices.rows() / 3, 3);
  for (Eigen::Index i = 0; i < result.triangles.size(); ++i) result.triangles.data()[i] = static_cast<std::int32_t>(i);
  return result;
}

TEST(PartCheck, CracksAtTJunctionsDoNotSplitThinRegions) {
  for (const Part& part : parts()) {
    const Shape shape = with_t_junctions(part.shape(0));
    EXPECT_FALSE(check_part(shape, part.limits).closed);
    expect_regions(part, shape, Eigen::Matrix3d::Identity(), "with T-junctions");
  }
}

/// Noise of 0.1 % of the diagonal moves each side of a wall by up to that much.
TEST(PartCheck, MinimumThicknessChangesAtMostByTwiceTheNoiseAmplitude) {
  for (const Part& part : parts()) {
    SCOPED_TRACE(part.name);
    if (part.curved) continue;
    Shape shape = part.shape(1);
    const double noise = 0.001 * bounding_box_diagonal(shape) / std::sqrt(3);
    const std::vector<std::int32_t> merged = welded_vertices(shape.vertices);
    RandomNumbers random(1);
    for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v) {
      const Eigen::Index first = merged[static_cast<std::size_t>(v)];
      if (first != v) {
        shape.vertices.row(v) = shape.vertices.row(first);
        continue;
      }
      for (double& coordinate : shape.vertices.row(v)) coordinate += random.uniform(-noise, noise);
    }
    const PartReport report = check_part(shape, part.limits);
    const ThinRegions& found = part.limits.min_wall > 0 ? report.walls : report.gaps;
    ASSERT_EQ(found.regions.size(), part.regions.size());
    for (std::size_t i = 0; i < found.regions.size(); ++i) {
      const Expected& expected = part.regions[i];
      EXPECT_NEAR(found.regions[i].minimum, expected.minimum, 2 * std::sqrt(3) * noise) << i;
      EXPECT_NEAR(found.regions[i].area, expected.area, 0.05 * expected.area) << i;
    }
  }
}

using Polygon = std::vector<Eigen::Vector2d>;

/// Regular polygon about a circle of a diameter.
Polygon regular(int sides, double diameter) {
  Polygon polygon;
  const double radius = diameter / 2 / std::cos(std::numbers::pi / sides);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * i * std::numbers::pi / sides;
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

/// Plate from x = 0 to 20 whose end at x = 0 is ground to a knife's edge of 40 degrees.
Polygon bevelled(double height) {
  return {{0, 0}, {20, 0}, {20, height}, {height / std::tan(40 * std::numbers::pi / 180), height}};
}

/// Cross-section of a solid: its height, and the factor applied to a convex polygon.
struct Section {
  double z;
  double scale;
};

/// Solid between sections of a convex polygon, upwards.
Shape solid(const Polygon& polygon, const std::vector<Section>& sections) {
  const auto sides = static_cast<int>(polygon.size());
  const auto last = static_cast<int>(sections.size()) - 1;
  std::vector<Eigen::Vector3d> vertices;
  for (const Section& section : sections) {
    for (const auto& corner : polygon) {
      vertices.emplace_back(section.scale * corner.x(), section.scale * corner.y(), section.z);
    }
  }
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    for (int k = 0; k < last; ++k) {
      triangles.emplace_back(k * sides + i, k * sides + next, (k + 1) * sides + next);
      triangles.emplace_back(k * sides + i, (k + 1) * sides + next, (k + 1) * sides + i);
    }
    if (i == 0 || next == 0) continue;
    triangles.emplace_back(0, next, i);
    triangles.emplace_back(last * sides, last * sides + i, last * sides + next);
  }
  return test::mesh_of(vertices, triangles);
}

Shape solid(const Polygon& polygon, double length) { return solid(polygon, {{0, 1}, {length, 1}}); }

TEST(PartCheck, SharpEdgesAreNotReportedAsThinWalls) {
  const Polygon triangle = regular(3, 2 * std::sqrt(3));  // of side 6
  const PartReport sharp = check_part(solid(triangle, 10), {.min_wall = wall_limit});
  ASSERT_EQ(sharp.walls.regions.size(), 3);
  EXPECT_TRUE(sharp.passes());
  for (const ThinRegion& region : sharp.walls.regions) {
    EXPECT_TRUE(region.is_edge);
    EXPECT_LT(region.minimum, 0.01);
    // Both sides of the edge, up to the limit.
    EXPECT_NEAR(region.area, 2 * 10 * wall_limit / (2 * std::tan(std::numbers::pi / 6)), 0.2);
  }
  const PartReport right_angled = check_part(test::box({3, 3, 3}, 1), {.min_wall = wall_limit});
  EXPECT_TRUE(right_angled.walls.regions.empty());
}

TEST(PartCheck, ThickPartsWithSharpEdgesAndTipsPass) {
  const double slope = std::tan(25 * std::numbers::pi / 180);
  const std::vector<Section> spike{{0, 1}, {3 / slope, 0}};  // of 50 degrees
  const std::vector<std::pair<std::string, Shape>> shapes{
      {"spike of 3 sides", solid(regular(3, 6), spike)},
      {"spike of 4 sides", solid(regular(4, 6), spike)},
      {"spike of 6 sides", solid(regular(6, 6), spike)},
      {"spike of 32 sides", solid(regular(32, 6), spike)},
      {"tetrahedron", solid(regular(3, 6), {{0, 1}, {std::sqrt(72), 0}})},
      {"knife's edge", solid(bevelled(2), 10)}};
  for (const auto& [name, shape] : shapes) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(check_part(shape, {.min_wall = wall_limit}).passes());
  }
}

TEST(PartCheck, SharpEdgesWithNoiseAreNotReportedAsThinWalls) {
  const Polygon coarse = regular(3, 2 * std::sqrt(3));
  Polygon fine;
  for (std::size_t i = 0; i < 24; ++i) {
    const double along = static_cast<double>(i % 8) / 8;
    fine.emplace_back((1 - along) * coarse[i / 8] + along * coarse[(i / 8 + 1) % 3]);
  }
  std::vector<Section> sections;
  for (int k = 0; k <= 20; ++k) sections.push_back({k / 2.0, 1});
  Shape shape = solid(fine, sections);
  RandomNumbers random(1);
  for (double& coordinate : shape.vertices.reshaped()) coordinate += random.uniform(-0.007, 0.007);
  EXPECT_TRUE(check_part(shape, {.min_wall = wall_limit}).passes());
}

/// All of them are thin everywhere, whatever their sections, and have sharp edges or points as well.
TEST(PartCheck, ThinRodsAndLimbsAreReportedAsThinWalls) {
  const double diameter = 2 * wall_limit / 3;
  const double tip = diameter / 2 / std::tan(25 * std::numbers::pi / 180);
  for (const int sides : {3, 4, 6, 8, 32}) {
    SCOPED_TRACE(sides);
    const Polygon polygon = regular(sides, diameter);
    for (const std::vector<Section>& sections :
         {std::vector<Section>{{0, 1}, {10, 1}}, std::vector<Section>{{0, 1}, {10, 1}, {10 + tip, 0}}}) {
      const Shape shape = solid(polygon, sections);
      const ThinRegions walls = check_part(shape, {.min_wall = wall_limit}).walls;
      ASSERT_EQ(walls.regions.size(), 1);
      EXPECT_FALSE(walls.regions[0].is_edge);
      EXPECT_LE(walls.regions[0].median, 1.001 * diameter);
      const double perimeter = 2 * sides * std::tan(std::numbers::pi / sides) * diameter / 2;
      EXPECT_GE(walls.regions[0].area, 0.99 * 10 * perimeter);
      EXPECT_LE(walls.regions[0].area, surface_area(shape));
    }
  }
  const ThinRegions capsule = check_part(test::capsule(wall_limit / 3, 10, 12, 6), {.min_wall = wall_limit}).walls;
  ASSERT_EQ(capsule.regions.size(), 1);
  EXPECT_FALSE(capsule.regions[0].is_edge);
}

TEST(PartCheck, ListsSmallViolationsBeforeLargeSharpEdges) {
  const Shape prism = solid(regular(3, 2 * std::sqrt(3)), 10);
  const PartReport report =
      check_part(test::joined({prism, block({20, 0, 0}, {22, 2, 1}, 1)}), {.min_wall = wall_limit});
  ASSERT_EQ(report.walls.regions.size(), 5);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(report.walls.regions[i].is_edge, i >= 2) << i;
  EXPECT_LT(report.walls.regions[0].area, report.walls.regions[4].area);
}

TEST(PartCheck, SharpRimOfAThinPlateBelongsToItsThinWall) {
  const PartReport report = check_part(solid(bevelled(1), 10), {.min_wall = wall_limit});
  ASSERT_EQ(report.walls.regions.size(), 1);
  EXPECT_FALSE(report.walls.regions[0].is_edge);
}

/// A tail of triangular section: its ridges are sharp edges where it is thick, and the thin end is a wall.
TEST(PartCheck, ThinLimbIsSeparatedFromAdjoiningSharpEdges) {
  const Shape tail = solid(regular(3, 6), {{0, 1}, {120, 0.05}});
  const PartReport report = check_part(tail, {.min_wall = wall_limit});
  EXPECT_FALSE(report.passes());
  EXPECT_TRUE(std::ranges::any_of(report.walls.regions, &ThinRegion::is_edge));
  const double sides = surface_area(tail) - 9 * std::sqrt(3) * 3 * (1 + 0.05 * 0.05);
  const auto area_below = [&](double scale) { return (scale * scale - 0.05 * 0.05) / (1 - 0.05 * 0.05) * sides; };
  const double scale = wall_limit / 6;  // beyond, all of the section is thin
  // Walls and edges are divided within the distance from there that sides which open by 30 degrees need.
  const double reach = wall_limit / 2 / std::tan(std::numbers::pi / 12);
  double area = 0;
  for (const ThinRegion& region : report.walls.regions) area += region.is_edge ? 0 : region.area;
  EXPECT_GE(area, area_below(scale - reach * 0.95 / 120));
  EXPECT_LE(area, area_below(scale + reach * 0.95 / 120));
}

TEST(PartCheck, CountsEnclosedVoids) {
  EXPECT_EQ(check_part(sphere_with_void().shape(0), {.min_gap = 1}).voids, 1);
  EXPECT_EQ(check_part(test::box({1, 1, 1}, 1), {.min_gap = 1}).voids, 0);
}

TEST(PartCheck, FindsTheSameWallsOnAMeshTurnedInsideOut) {
  const Part part = plate();
  expect_regions(part, test::flipped(part.shape(1)), Eigen::Matrix3d::Identity(), "inside out");
}

TEST(PartCheck, ThinRegionsListTheirFaces) {
  const Shape shape = plate().shape(0);
  const PartReport report = check_part(shape, {.min_wall = wall_limit});
  ASSERT_EQ(report.walls.regions.size(), 2);
  for (const ThinRegion& region : report.walls.regions) {
    ASSERT_EQ(region.faces.size(), 2);
    for (const std::int32_t face : region.faces) {
      EXPECT_NEAR(std::abs(triangle_normal(shape, face).z()), 1, 1e-12);
      EXPECT_NEAR(shape.vertices(shape.triangles(face, 0), 2), region.position.z(), 1e-9);
    }
  }
}

TEST(PartCheck, SubdividesTheSurfaceAlongBordersOfThinRegions) {
  const Part part = stepped_plate();
  const Shape shape = part.shape(0);
  CheckOptions options = part.limits;
  options.min_gap = gap_limit;
  options.keep_surface = true;
  const CheckedSurface surface = check_part(shape, options).surface;
  ASSERT_EQ(surface.fractions.size(), surface.mesh.triangles.rows());
  EXPECT_NEAR(surface_area(surface.mesh), surface_area(shape), 1e-9);
  const Eigen::VectorXd areas = triangle_areas(surface.mesh);
  double thin = 0;
  for (Eigen::Index f = 0; f < areas.size(); ++f) {
    if (std::isnan(surface.fractions[f])) continue;
    EXPECT_GE(surface.fractions[f], 1 / wall_limit - 1e-9);
    EXPECT_LT(surface.fractions[f], 1);
    thin += areas[f];
  }
  const double expected = part.regions[0].area + part.regions[1].area;
  EXPECT_NEAR(thin, expected, 0.02 * expected);
}

TEST(PartCheck, ThinRegionsBelowTheMinimumAreaAreCountedButNotListed) {
  const Part part = wedge();
  const double smaller = part.regions[1].area;
  const PartReport report =
      check_part(part.shape(0), {.min_wall = wall_limit, .min_area = (smaller + part.regions[0].area) / 2});
  EXPECT_EQ(report.walls.regions.size(), 1);
  EXPECT_EQ(report.walls.small_regions, 1);
  EXPECT_NEAR(report.walls.small_area, smaller, 0.01 * smaller);
}

TEST(PartCheck, PartSmallerThanTheThicknessLimitIsOneThinWall) {
  const Shape box = test::box({1, 1, 1}, 1);
  for (const double limit : {2.0, 30.0, 1e6}) {
    const PartReport report = check_part(box, {.min_wall = limit});
    ASSERT_EQ(report.walls.regions.size(), 1) << limit;
    EXPECT_FALSE(report.passes()) << limit;
    EXPECT_NEAR(report.walls.regions[0].area, surface_area(box), 1e-9) << limit;
    EXPECT_NEAR(report.walls.regions[0].minimum, 1, 1e-9) << limit;
  }
}

TEST(PartCheck, ReportIsTheSameOnOneAndSeveralThreads) {
  const Shape shape = lattice().shape(1);
  CheckOptions options = lattice().limits;
  const PartReport all = check_part(shape, options);
  options.ball.parallel = false;
  const PartReport one = check_part(shape, options);
  ASSERT_EQ(one.walls.regions.size(), all.walls.regions.size());
  EXPECT_EQ(one.walls.regions[0].area, all.walls.regions[0].area);
  EXPECT_EQ(one.walls.regions[0].median, all.walls.regions[0].median);
  EXPECT_EQ(one.walls.regions[0].position, all.walls.regions[0].position);
}

TEST(PartCheck, RejectsCloudsAndMissingNegativeOrNonFiniteLimits) {
  const Shape box = test::box({1, 1, 1}, 1);
  EXPECT_THROW(check_part(test::random_points(box, 10, 1), {.min_wall = 1}), InputError);
  EXPECT_THROW(check_part(box, {}), ArgumentError);
  for (const double bad : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_THROW(check_part(box, {.min_wall = bad}), ArgumentError) << bad;
    EXPECT_THROW(check_part(box, {.min_wall = 1, .min_area = bad}), ArgumentError) << bad;
  }
}

}  // namespace
}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <rapidcheck.h>
#include <utility>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/closest_point.h"
#include "tests/support/test_shapes.h"

/// Triangle soups that are difficult for spatial searches.
namespace shapegauge {

/// Shape whose triangles share no vertices.
inline Shape soup_of(const std::vector<Triangle>& triangles) {
  std::vector<Eigen::Vector3d> corners;
  for (const Triangle& t : triangles) corners.insert(corners.end(), {t.a, t.b, t.c});
  return test::soup_of(corners);
}

enum class Soup {
  scattered,   ///< at random positions, of sizes over several orders of magnitude, every tenth degenerate
  coplanar,    ///< in one plane that no axis is normal to
  lattice,     ///< corners on a coarse grid: coplanar, touching, degenerate and duplicate triangles abound
  needles,     ///< long, and of hardly any area
  points,      ///< no extent at all
  duplicated,  ///< a few triangles, many times over, either way round
};

inline const std::vector<Soup> all_soups{Soup::scattered, Soup::coplanar, Soup::lattice,
                                         Soup::needles,   Soup::points,   Soup::duplicated};

class SoupMaker {
 public:
  SoupMaker(Soup kind, unsigned seed) : kind_(kind), generator_(seed) {}

  Shape make(int count) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; ++i) {
      if (kind_ == Soup::duplicated && i >= 7) {
        Triangle copy = triangles[static_cast<std::size_t>(i % 7)];
        if (i % 2 == 0) std::swap(copy.b, copy.c);
        triangles.push_back(copy);
      } else {
        triangles.push_back(triangle(i));
      }
    }
    return soup_of(triangles);
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }

  Eigen::Vector3d in_cube() {
    const double x = uniform(-0.5, 0.5);
    const double y = uniform(-0.5, 0.5);
    return {x, y, uniform(-0.5, 0.5)};
  }

  Eigen::Vector3d on_lattice() { return (8 * in_cube()).array().round() / 8; }

  Triangle triangle(int i) {
    const Eigen::Vector3d centre = in_cube();
    const double size = std::pow(10, uniform(-4, -0.5));
    Triangle t{centre + size * in_cube(), centre + size * in_cube(), centre + size * in_cube()};
    if (kind_ == Soup::lattice) return {on_lattice(), on_lattice(), on_lattice()};
    if (kind_ == Soup::points) return {centre, centre, centre};
    if (kind_ == Soup::needles) return {centre, centre + in_cube(), centre + 1e-9 * in_cube()};
    if (kind_ == Soup::coplanar) {
      const Eigen::Vector3d normal = Eigen::Vector3d(1, 2, 3).normalized();
      for (Eigen::Vector3d* corner : {&t.a, &t.b, &t.c}) *corner -= normal.dot(*corner) * normal;
    }
    if (i % 10 == 0) t.b = t.a;
    if (i % 20 == 0) t.c = t.a;
    return t;
  }

  Soup kind_;
  std::mt19937 generator_;
};

/// Generator of soups of all kinds for RapidCheck.
inline Shape any_soup(int most) {
  const Soup kind = *rc::gen::elementOf(all_soups);
  const int count = *rc::gen::inRange(1, most);
  return SoupMaker(kind, *rc::gen::inRange(0U, 100'000U)).make(count);
}

inline Triangle triangle_of(const Shape& shape, Eigen::Index f) {
  return {shape.vertices.row(shape.triangles(f, 0)), shape.vertices.row(shape.triangles(f, 1)),
          shape.vertices.row(shape.triangles(f, 2))};
}

/// Relation of a ray to a triangle.
struct RayMeeting {
  bool sure = true;  ///< false where the ray passes so close to a side, begins so close to the plane, or grazes it so
                     ///< flatly that rounding may decide
  bool crosses = false;
  bool along_normal = false;
  double distance = 0;
};

/// Classifies by the signs of the volumes spanned by ray and sides; `unsure` is a tolerance, as a distance. Coordinates
/// of a unit cube in single precision may displace the plane by 2^-22.
inline RayMeeting meeting_of(const Triangle& t, const Eigen::Vector3d& x, const Eigen::Vector3d& direction,
                             double unsure) {
  for (const auto& [p, q] : {std::pair(t.a, t.b), {t.b, t.c}, {t.c, t.a}}) {
    // Distance of the line from the side, in projection along the line.
    const auto across = [&](const Eigen::Vector3d& y) -> Eigen::Vector3d {
      return (y - x) - (y - x).dot(direction) * direction;
    };
    if (closest_point_on_segment(across(p), across(q), Eigen::Vector3d::Zero()).norm() < unsure) return {.sure = false};
  }
  const auto volume = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return direction.dot((p - x).cross(q - x));
  };
  const double u = volume(t.a, t.b);
  const double v = volume(t.b, t.c);
  const double w = volume(t.c, t.a);
  if (!((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0))) return {};
  const Eigen::Vector3d normal = (t.b - t.a).cross(t.c - t.a);
  const double distance = normal.dot(t.a - x) / normal.dot(direction);
  const double displaced = 0x1p-22 / std::abs(normal.normalized().dot(direction));  // along the ray
  if (!(std::abs(distance) > unsure && displaced < unsure)) return {.sure = false};
  return {.crosses = distance > 0, .along_normal = u > 0, .distance = distance};
}

}  // namespace shapegauge

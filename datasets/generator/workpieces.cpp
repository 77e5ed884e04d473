// SPDX-License-Identifier: GPL-3.0-or-later
// Machine parts, tools and spectacles.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shapegauge/datasets/generator/drawn_objects.h"

namespace shapegauge {

using Eigen::Vector3d;

namespace {

/// Makes a lens around the y axis through a point of the x axis, elliptical as the ring is.
Solid lens_at(double centre, double width, double height) {
  const Eigen::Isometry3d upright(Eigen::Translation3d(centre, 0, 0) *
                                  Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()));
  const Solid disc = transformed_solid(rounded_cylinder({0, 0, -0.025}, {0, 0, 0.025}, width, 0.01), upright);
  const double flat = height / width;
  return {[disc, flat](const Vector3d& p) { return flat * disc.distance({p.x(), p.y(), p.z() / flat}); }, disc.box};
}

}  // namespace

SolidObject draw_spectacles(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  const double wire = draw(0.025, 0.05);
  const double width = draw(0.28, 0.38);
  const double height = width * draw(0.6, 1);
  const double gap = draw(0.08, 0.14);
  const bool lenses = draw.happens(0.5);
  object.thinnest = lenses ? 0.05 : 2 * wire;
  object.blend = 0.01;
  const double length = draw(0.9, 1.4);
  const double splay = draw(-0.1, 0.3);
  int side_label = 0;
  for (const double side : {-1.0, 1.0}) {
    const double centre = side * (gap + width);
    std::vector<LimbNode> ring;
    for (int i = 0; i <= 20; ++i) {
      const double turn = 2 * std::numbers::pi * i / 20;
      ring.push_back({{centre + width * std::cos(turn), 0, height * std::sin(turn)}, wire});
    }
    object.parts.push_back({side_label, tube(ring)});
    if (lenses) object.parts.push_back({side_label, lens_at(centre, width, height)});
    const double hinge = centre + side * (width + 0.5 * wire);
    object.parts.push_back({2 + side_label, tube({{{hinge, 0, 0.1 * height}, 1.2 * wire},
                                                  {{hinge + side * 0.3 * splay, -0.5 * length, 0.1 * height}, wire},
                                                  {{hinge + side * splay, -length, 0.1 * height}, wire},
                                                  {{hinge + side * splay, -1.2 * length, -0.1}, 1.2 * wire}})});
    ++side_label;
  }
  const double arch = draw(0, 0.12);
  object.parts.push_back({4, tube({{{-gap, 0, 0.1 * height}, wire},
                                   {{0, 0.02, 0.1 * height + arch}, wire},
                                   {{gap, 0, 0.1 * height}, wire}})});
  return object;
}

/// Turned pieces above each other, each with its own radius: a shaft, a bearing, a flange.
SolidObject draw_shaft(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  object.blend = 0.01;
  const int pieces = draw.from(2, 4);
  double at = 0;
  double least = 1;
  double radius = draw(0.2, 0.8);
  for (int i = 0; i < pieces; ++i) {
    const double length = draw(0.12, 0.9);
    object.parts.push_back({i, rounded_cylinder({0, 0, at - 0.02}, {0, 0, at + length}, radius, 0.02)});
    least = std::min(least, radius);
    at += length;
    // Clearly different from the last radius.
    const double factor = draw(1.4, 2.6);
    radius = radius > 0.4 || (radius > 0.25 && draw.happens(0.5)) ? radius / factor : radius * factor;
  }
  if (draw.happens(0.4)) {
    const double bore = least * draw(0.3, 0.65);
    object.thinnest = std::min(0.1, least - bore);
    const Solid hole = rounded_cylinder({0, 0, -1}, {0, 0, at + 1}, bore, 0.01);
    for (SolidPart& part : object.parts) part.solid = difference(part.solid, hole);
  }
  return object;
}

/// A base with an upright plate, bosses and holes.
SolidObject draw_bracket(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  object.blend = 0.01;
  const double thick = draw(0.06, 0.12);
  const double wide = draw(0.3, 0.6);
  const Vector3d half(draw(0.5, 0.9), wide, thick);
  Solid base = rounded_box({0, 0, 0}, half, 0.02);
  const double hole = draw(0.07, 0.12);
  for (const double side : {-1.0, 1.0}) {
    const Vector3d at(side * (half.x() - 2 * hole), half.y() - 2 * hole, 0);
    base = difference(base, rounded_cylinder(at - Vector3d::UnitZ(), at + Vector3d::UnitZ(), hole, 0.01));
  }
  object.parts.push_back({0, base});
  object.thinnest = thick;
  if (draw.happens(0.7)) {
    const double height = draw(0.4, 1);
    object.parts.push_back(
        {1, rounded_box({0, -half.y() + thick, height / 2}, {half.x() * draw(0.4, 1), thick, height / 2}, 0.02)});
  }
  const int bosses = draw.from(1, 2);
  for (int i = 0; i < bosses; ++i) {
    const double radius = draw(0.15, 0.22);
    const Vector3d at(bosses == 1 ? draw(-0.2, 0.2) : (i - 0.5) * half.x(), 0.05, 0);
    const double height = draw(0.3, 0.9);
    Solid boss = rounded_cylinder(at, at + height * Vector3d::UnitZ(), radius, 0.02);
    if (draw.happens(0.4)) {
      boss = difference(boss,
                        rounded_cylinder(at + 0.2 * Vector3d::UnitZ(), at + 2 * Vector3d::UnitZ(), radius / 2, 0.01));
    }
    object.parts.push_back({2 + i, boss});
  }
  return object;
}

SolidObject draw_hammer(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  const double length = draw(1.2, 2);
  const double grip = draw(0.06, 0.11);
  const double oval = draw(0.7, 1);
  const double end = grip * draw(0.9, 1.4);
  object.parts.push_back(
      {0, tube({{{0, 0, 0}, end}, {{0, 0, 0.4 * length}, grip}, {{0, 0, length}, 0.9 * grip}}, {1, 0, 0}, oval)});
  const double reach = draw(0.25, 0.5);
  const double size = draw(0.13, 0.22);
  const bool round = draw.happens(0.5);
  const Vector3d front(reach, 0, length);
  const Vector3d back(-reach * draw(0.4, 1), 0, length);
  object.parts.push_back({1, round ? rounded_cylinder(back, front, size, 0.03) : post(back, front, size, true)});
  if (draw.happens(0.4)) {
    object.parts.push_back({2, tube({{back, 0.8 * size},
                                     {back + Vector3d(-0.25, 0, -0.03), 0.6 * size},
                                     {back + Vector3d(-0.5, 0, -0.2), 0.4 * size}},
                                    {0, 0, 1}, 0.5)});
  }
  return object;
}

}  // namespace shapegauge

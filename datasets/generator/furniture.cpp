// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of furniture.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapegauge/core/base/decompositions.h"
#include "shapegauge/datasets/generator/drawn_objects.h"

namespace shapegauge {

using Eigen::Vector3d;

Solid post(const Vector3d& from, const Vector3d& to, double radius, bool square) {
  if (!square) return tube({{from, radius}, {to, radius}});
  const Vector3d middle = (from + to) / 2;
  const Vector3d half(radius, radius, (to - from).norm() / 2);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = rotation_between(Vector3d::UnitZ(), to - from);
  motion.translation() = middle;
  return transformed_solid(rounded_box(Vector3d::Zero(), half, radius / 3), motion);
}

namespace {

/// Adds four splayed legs under the corners of a plate; labels from `first` on. `corner` is on the plate's upper side.
void add_legs(SolidObject& object, int first, const Vector3d& corner, double height, Draw& draw) {
  const double radius = draw(0.04, 0.09);
  const double splay = draw.happens(0.5) ? 0 : draw(0, 0.25);
  const bool square = draw.happens(0.5);
  const bool curved = !square && draw.happens(0.3);
  const double bulge = draw(-0.12, 0.12);
  const double foot_radius = radius * draw(0.6, 1.1);
  int label = first;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const Vector3d top(x * corner.x(), y * corner.y(), corner.z() - radius);
      const Vector3d foot = top + Vector3d(x * splay, y * splay, -height);
      const Vector3d knee = (top + foot) / 2 + Vector3d(x * bulge, y * bulge, 0);
      object.parts.push_back({label++, curved ? tube({{top, radius}, {knee, radius}, {foot, foot_radius}})
                                              : post(top, foot, radius, square)});
    }
  }
}

/// Adds a column in the middle with a foot: labels `column` and `column + 1`.
void add_column(SolidObject& object, int column, double height, double foot_radius, Draw& draw) {
  const double radius = draw(0.06, 0.13);
  object.parts.push_back({column, rounded_cylinder({0, 0, -height}, {0, 0, 0}, radius, radius / 4)});
  if (draw.happens(0.5)) {
    const double thickness = draw(0.06, 0.12);
    object.parts.push_back({column + 1, rounded_cylinder({0, 0, -height - thickness / 2},
                                                         {0, 0, -height + thickness / 2}, foot_radius, thickness / 4)});
    return;
  }
  const int feet = draw.from(3, 5);
  const double slope = draw(0, 0.2);
  for (int i = 0; i < feet; ++i) {
    const double turn = 2 * std::numbers::pi * i / feet;
    const Vector3d out(std::cos(turn), std::sin(turn), 0);
    const Vector3d low(0, 0, -height);
    object.parts.push_back({column + 1 + i, tube({{low + Vector3d(0, 0, slope), radius * 0.7},
                                                  {low + foot_radius * out, radius * 0.55}})});
  }
}

Solid plate_top(const Vector3d& half, bool round) {
  if (!round) return rounded_box({0, 0, 0}, half, 0.4 * half.z());
  return rounded_cylinder({0, 0, -half.z()}, {0, 0, half.z()}, half.x(), 0.4 * half.z());
}

/// Makes a chair's back above y = -half.y(): a panel or two posts with a rail.
Solid chair_back(const Vector3d& half, double height, double thickness, double lean) {
  const Eigen::Isometry3d motion(Eigen::Translation3d(0, -half.y() + thickness, 0) *
                                 Eigen::AngleAxisd(lean, Vector3d::UnitX()));
  return transformed_solid(
      rounded_box({0, 0, height / 2}, {half.x(), thickness, height / 2 + thickness}, thickness / 2), motion);
}

void add_open_back(SolidObject& object, int label, const Vector3d& half, double height, double thickness, Draw& draw) {
  for (const double side : {-1.0, 1.0}) {
    const Vector3d root(side * (half.x() - thickness), -half.y() + thickness, 0);
    object.parts.push_back({label, post(root, root + Vector3d(0, -0.1, height), thickness, true)});
  }
  const int rails = draw.from(1, 3);
  for (int i = 0; i < rails; ++i) {
    const double share = rails == 1 ? 0.9 : 0.4 + 0.52 * i / (rails - 1);
    object.parts.push_back({label, rounded_box({0, -half.y() + thickness - 0.1 * share, share * height},
                                               {half.x() - thickness, 0.8 * thickness, 0.09 * height}, thickness / 3)});
  }
}

void add_arms(SolidObject& object, int first, const Vector3d& half, double thickness, bool solid, Draw& draw) {
  const double height = draw(0.25, 0.4);
  int label = first;
  for (const double side : {-1.0, 1.0}) {
    const double x = side * (half.x() - thickness);
    if (solid) {
      object.parts.push_back({label++, rounded_box({x + side * thickness, 0, height / 2},
                                                   {1.5 * thickness, half.y(), height / 2 + half.z()}, thickness)});
      continue;
    }
    const Vector3d front(x, 0.6 * half.y(), 0);
    const Vector3d elbow(x, 0.6 * half.y(), height);
    const Vector3d back(x, -half.y() + thickness, height);
    object.parts.push_back({label, post(front, elbow, 0.8 * thickness, true)});
    object.parts.push_back({label++, post(elbow, back, 0.8 * thickness, true)});
  }
}

}  // namespace

SolidObject draw_table(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  const bool round = draw.happens(0.4);
  const double height = draw(0.5, 1.3);
  const double thin = draw(0.03, 0.07);
  const double wide = draw(0.45, 0.7);
  const Vector3d half(draw(0.6, 1), wide, thin);
  object.thinnest = 2 * half.z();
  object.parts.push_back({0, plate_top(half, round)});
  if (draw.happens(round ? 0.6 : 0.25)) {
    add_column(object, 5, height, draw(0.35, 0.6), draw);
    return object;
  }
  const double inset = round ? 0.6 * half.x() : half.x() - draw(0.1, 0.2);
  const double inset_side = round ? inset : half.y() - draw(0.1, 0.15);
  add_legs(object, 1, {inset, inset_side, half.z()}, height, draw);
  return object;
}

SolidObject draw_chair(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  const bool fat = draw.happens(0.25);
  const double seat = fat ? draw(0.12, 0.2) : draw(0.035, 0.07);
  const double wide = draw(0.4, 0.55);
  const Vector3d half(draw(0.4, 0.6), wide, seat);
  const double thickness = fat ? draw(0.08, 0.13) : draw(0.035, 0.06);
  const double back = draw(0.5, 1.1);
  object.thinnest = 1.5 * std::min(half.z(), thickness);
  object.parts.push_back({0, plate_top(half, false)});
  if (fat || draw.happens(0.6)) {
    object.parts.push_back({1, chair_back(half, back, thickness, draw(0, 0.2))});
  } else {
    add_open_back(object, 1, half, back, thickness, draw);
  }
  const double height = fat ? draw(0.2, 0.4) : draw(0.45, 0.8);
  if (!fat && draw.happens(0.2)) {
    add_column(object, 8, height, draw(0.35, 0.5), draw);
  } else {
    add_legs(object, 2, {half.x() - 0.1, half.y() - 0.1, half.z()}, height, draw);
  }
  if (fat || draw.happens(0.35)) add_arms(object, 6, half, thickness, fat, draw);
  return object;
}

}  // namespace shapegauge

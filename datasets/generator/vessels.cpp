// SPDX-License-Identifier: GPL-3.0-or-later
// Vessels: bodies of revolution, hollow, with handles.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "shapegauge/datasets/generator/drawn_objects.h"

namespace shapegauge {

using Eigen::Vector3d;

namespace {

/// Makes a handle from one height of a vessel's wall to a lower one: round or straight.
Solid ear(const Vector3d& high, const Vector3d& low, double reach, double radius, Draw& draw) {
  const double lift = draw(-0.05, 0.1);
  const double boxy = draw(0.7, 1);
  const Vector3d out(reach, 0, 0);
  const Vector3d up(0, 0, lift);
  const double outer = std::max(high.x(), low.x());
  const Vector3d far_high(outer, 0, high.z());
  const Vector3d far_low(outer, 0, low.z());
  return tube({{high, radius},
               {far_high + boxy * out + up, radius},
               {(far_high + far_low) / 2 + 1.1 * out, radius},
               {far_low + boxy * out, radius},
               {low, radius}},
              {0, 1, 0}, draw(0.8, 1.4));
}

/// Makes a smooth outline through radii at heights.
Outline smooth_outline(const Outline& nodes) {
  constexpr int pieces = 6;
  Outline outline;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    for (int k = 0; k < pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      const double s = (1 - std::cos(std::numbers::pi * t)) / 2;
      outline.emplace_back(nodes[i - 1].x() + s * (nodes[i].x() - nodes[i - 1].x()),
                           nodes[i - 1].y() + t * (nodes[i].y() - nodes[i - 1].y()));
    }
  }
  outline.push_back(nodes.back());
  return outline;
}

/// Closes an outline at the axis.
Outline with_floor(const Outline& outline, double height) {
  Outline result(outline.size() + 1);
  result.front() = {0, height};
  std::ranges::copy(outline, result.begin() + 1);
  return result;
}

double radius_at(const Outline& outline, double height) {
  const auto above = std::ranges::find_if(outline, [&](const Eigen::Vector2d& point) { return point.y() >= height; });
  return above == outline.end() ? outline.back().x() : above->x();
}

/// None, one or two handles opposite to each other, between two heights.
struct Handles {
  int count;
  double upper;
  double lower;
  double reach;
  double radius;
};

/// Adds handles to a vessel of this outline, with labels from `first_label`.
void add_handles(const Handles& handles, const Outline& outline, int first_label, SolidObject& object, Draw& draw) {
  const Solid filled = revolved(outline, 0);
  for (int i = 0; i < handles.count; ++i) {
    const Solid handle =
        ear({radius_at(outline, handles.upper), 0, handles.upper},
            {radius_at(outline, handles.lower), 0, handles.lower}, handles.reach, handles.radius, draw);
    object.parts.push_back({first_label + i, rotated_about_z(difference(handle, filled), 180 * i)});
  }
}

}  // namespace

SolidObject draw_mug(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  const double wall = draw(0.05, 0.1);
  const double bottom = draw(0.3, 0.55);
  const double rim = bottom * draw(0.85, 1.5);
  const double height = draw(0.6, 1.4);
  const double bulge = draw(-0.08, 0.15);
  Outline outline;
  for (int i = 0; i <= 16; ++i) {
    const double t = i / 16.0;
    outline.emplace_back(bottom + t * (rim - bottom) + bulge * std::sin(std::numbers::pi * t), t * height);
  }
  object.thinnest = wall;
  object.parts.push_back({0, revolved_wall(with_floor(outline, draw(0, 0.08)), wall)});
  const Handles handles{.count = draw.from(4, 10) / 5,  // seldom none or two
                        .upper = height * draw(0.65, 0.92),
                        .lower = height * draw(0.1, 0.35),
                        .reach = draw(0.2, 0.45),
                        .radius = draw(0.05, 0.09)};
  add_handles(handles, outline, 1, object, draw);
  return object;
}

SolidObject draw_vase(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  constexpr double overlap = 0.03;
  const bool hollow = draw.happens(0.6);
  const bool footed = draw.happens(0.6);
  const bool necked = draw.happens(0.75);
  const double belly = draw(0.4, 0.65);
  const double neck = belly * draw(0.3, 0.55);
  const double stem = belly * draw(0.25, 0.6);
  const double foot_height = draw(0.2, 0.5);
  const double belly_height = foot_height + draw(0.4, 0.7);
  const double shoulder = belly_height + draw(0.3, 0.5);
  Outline nodes;
  if (footed) nodes.emplace_back(stem * draw(1.3, 1.9), 0);
  nodes.emplace_back(stem, footed ? foot_height : 0);
  nodes.emplace_back(belly, belly_height);
  nodes.emplace_back(necked ? neck : belly * draw(0.7, 1), shoulder);
  const double top = necked ? shoulder + draw(0.2, 0.7) : shoulder;
  if (necked) nodes.emplace_back(neck * draw(0.9, 1.9), top);
  const Outline outline = smooth_outline(nodes);
  const double wall = draw(0.05, 0.09);
  object.thinnest = hollow ? wall : 0.1;
  Outline above_foot = outline;
  if (footed) std::erase_if(above_foot, [&](const Eigen::Vector2d& point) { return point.y() < foot_height; });
  const Solid vessel =
      hollow ? revolved_wall(with_floor(above_foot, above_foot.front().y()), wall) : revolved(outline, 0.02);
  const double low = footed ? foot_height : -1;
  const double high = necked ? belly_height + 0.75 * (shoulder - belly_height) : top + 1;
  object.parts.push_back({0, intersection(vessel, slab(low - overlap, high + overlap))});
  if (necked) object.parts.push_back({1, intersection(vessel, slab(high, top + 1))});
  if (footed) object.parts.push_back({2, intersection(revolved(outline, 0.02), slab(-1, low + 0.02))});
  const Handles handles{.count = draw.happens(0.5) ? 0 : draw.from(1, 2),
                        .upper = necked ? shoulder + draw(0, 0.5) * (top - shoulder) : shoulder - 0.05,
                        .lower = belly_height + draw(-0.1, 0.1),
                        .reach = draw(0.1, 0.3),
                        .radius = draw(0.04, 0.07)};
  add_handles(handles, outline, 3, object, draw);
  return object;
}

SolidObject draw_teapot(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  const double belly = draw(0.5, 0.75);
  const double height = draw(0.6, 1);
  const double opening = belly * draw(0.45, 0.7);
  const Outline outline = smooth_outline({{belly * draw(0.5, 0.8), 0}, {belly, 0.45 * height}, {opening, height}});
  const Solid body = revolved(outline, 0.03);
  object.parts.push_back({0, body});
  const double root = draw(0.2, 0.5) * height;
  const double rise = draw(0.6, 1.1) * height;
  const double thick = draw(0.1, 0.17);
  object.parts.push_back({1, difference(tube({{{0.8 * belly, 0, root}, thick},
                                              {{belly + 0.2, 0, root + 0.3 * (rise - root)}, 0.75 * thick},
                                              {{belly + draw(0.3, 0.5), 0, rise}, 0.55 * thick}}),
                                        revolved(outline, 0))});
  const double high = height * draw(0.75, 0.9);
  const double low = height * draw(0.2, 0.4);
  const double thin = draw(0.05, 0.08);
  const double reach = draw(0.25, 0.45);
  const Solid handle = ear({radius_at(outline, high), 0, high}, {radius_at(outline, low), 0, low}, reach, thin, draw);
  object.parts.push_back({2, rotated_about_z(difference(handle, revolved(outline, 0)), 180)});
  const double knob = draw(0.08, 0.14);
  object.parts.push_back({3, revolved({{0.4 * knob, height},
                                       {0.4 * knob, height + knob},
                                       {knob, height + 1.7 * knob},
                                       {0.5 * knob, height + 2.4 * knob}},
                                      0.02)});
  return object;
}

}  // namespace shapegauge

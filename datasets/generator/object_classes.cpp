#include "shapegauge/datasets/generator/object_classes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace shapegauge {

// The classes: objects of about the size of 2 units, drawn at random; z is up.

namespace {

using Eigen::Vector3d;

/// Draws what an object is like.
class Draw {
 public:
  explicit Draw(RandomNumbers& random) : random_(random) {}

  double operator()(double low, double high) { return random_.uniform(low, high); }
  bool happens(double probability) { return random_.uniform(0, 1) < probability; }
  int from(int low, int high) {
    return low + static_cast<int>(random_.below(static_cast<std::uint64_t>(high - low + 1)));
  }

 private:
  RandomNumbers& random_;
};

/// A straight leg or post, square or round.
Solid post(const Vector3d& from, const Vector3d& to, double radius, bool square) {
  if (!square) return tube({{from, radius}, {to, radius}});
  const Vector3d middle = (from + to) / 2;
  const Vector3d half(radius, radius, (to - from).norm() / 2);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), to - from).toRotationMatrix();
  motion.translation() = middle;
  return moved(rounded_box(Vector3d::Zero(), half, radius / 3), motion);
}

/// Four legs under the corners of a plate, splayed; labels from `first` on. `corner` is on the plate's upper side.
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

/// A column in the middle with a foot: labels `column` and `column + 1`.
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

SolidObject table(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  const bool round = draw.happens(0.4);
  const double height = draw(0.5, 1.3);
  const Vector3d half(draw(0.6, 1), draw(0.45, 0.7), draw(0.03, 0.07));
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

/// A handle from one height of a vessel's wall to a lower one: round as an ear, or straight.
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

/// A vessel's outline of these radii at heights: smooth in between.
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

/// The outline from the axis on.
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

SolidObject mug(RandomNumbers& random) {
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
  const Solid filled = revolved(outline, 0);
  object.thinnest = wall;
  object.parts.push_back({0, revolved_wall(with_floor(outline, draw(0, 0.08)), wall)});
  const int handles = draw.from(4, 10) / 5;  // seldom none or two
  const double high = height * draw(0.65, 0.92);
  const double low = height * draw(0.1, 0.35);
  const double reach = draw(0.2, 0.45);
  const double radius = draw(0.05, 0.09);
  for (int i = 0; i < handles; ++i) {
    const Solid handle =
        ear({radius_at(outline, high), 0, high}, {radius_at(outline, low), 0, low}, reach, radius, draw);
    object.parts.push_back({1 + i, turned_about_z(without(handle, filled), 180 * i)});
  }
  return object;
}

SolidObject vase(RandomNumbers& random) {
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
  object.parts.push_back({0, common(vessel, slab(low - overlap, high + overlap))});
  if (necked) object.parts.push_back({1, common(vessel, slab(high, top + 1))});
  if (footed) object.parts.push_back({2, common(revolved(outline, 0.02), slab(-1, low + 0.02))});
  const int handles = draw.happens(0.5) ? 0 : draw.from(1, 2);
  const double handle_top = necked ? shoulder + draw(0, 0.5) * (top - shoulder) : shoulder - 0.05;
  const double handle_end = belly_height + draw(-0.1, 0.1);
  const double reach = draw(0.1, 0.3);
  const double radius = draw(0.04, 0.07);
  for (int i = 0; i < handles; ++i) {
    const Solid handle = ear({radius_at(outline, handle_top), 0, handle_top},
                             {radius_at(outline, handle_end), 0, handle_end}, reach, radius, draw);
    object.parts.push_back({3 + i, turned_about_z(without(handle, revolved(outline, 0)), 180 * i)});
  }
  return object;
}

SolidObject teapot(RandomNumbers& random) {
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
  object.parts.push_back({1, without(tube({{{0.8 * belly, 0, root}, thick},
                                           {{belly + 0.2, 0, root + 0.3 * (rise - root)}, 0.75 * thick},
                                           {{belly + draw(0.3, 0.5), 0, rise}, 0.55 * thick}}),
                                     revolved(outline, 0))});
  const double high = height * draw(0.75, 0.9);
  const double low = height * draw(0.2, 0.4);
  const Solid handle = ear({radius_at(outline, high), 0, high}, {radius_at(outline, low), 0, low}, draw(0.25, 0.45),
                           draw(0.05, 0.08), draw);
  object.parts.push_back({2, turned_about_z(without(handle, revolved(outline, 0)), 180)});
  const double knob = draw(0.08, 0.14);
  object.parts.push_back({3, revolved({{0.4 * knob, height},
                                       {0.4 * knob, height + knob},
                                       {knob, height + 1.7 * knob},
                                       {0.5 * knob, height + 2.4 * knob}},
                                      0.02)});
  return object;
}

/// A chair's back above y = -half.y(): a panel or two posts with a rail.
Solid chair_back(const Vector3d& half, double height, double thickness, double lean) {
  const Eigen::Isometry3d motion(Eigen::Translation3d(0, -half.y() + thickness, 0) *
                                 Eigen::AngleAxisd(lean, Vector3d::UnitX()));
  return moved(rounded_box({0, 0, height / 2}, {half.x(), thickness, height / 2 + thickness}, thickness / 2), motion);
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

SolidObject chair(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  const bool fat = draw.happens(0.25);
  const Vector3d half(draw(0.4, 0.6), draw(0.4, 0.55), fat ? draw(0.12, 0.2) : draw(0.035, 0.07));
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

SolidObject spectacles(RandomNumbers& random) {
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
    if (lenses) {
      Solid lens = rounded_cylinder({0, 0, -0.025}, {0, 0, 0.025}, width, 0.01);
      Eigen::Isometry3d upright(Eigen::Translation3d(centre, 0, 0) *
                                Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()));
      // Of an ellipse, as the ring is.
      const Solid disc = moved(lens, upright);
      const double flat = height / width;
      object.parts.push_back({side_label,
                              {[disc, flat](const Vector3d& p) {
                                 return flat * disc.distance({p.x(), p.y(), p.z() / flat});
                               },
                               disc.box}});
    }
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

/// Turned pieces one above the other, each with its own radius: a shaft, a bearing, a flange.
SolidObject shaft(RandomNumbers& random) {
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
    // Far enough from the last one to be seen as another piece.
    const double factor = draw(1.4, 2.6);
    radius = radius > 0.4 || (radius > 0.25 && draw.happens(0.5)) ? radius / factor : radius * factor;
  }
  if (draw.happens(0.4)) {
    const double bore = least * draw(0.3, 0.65);
    object.thinnest = std::min(0.1, least - bore);
    const Solid hole = rounded_cylinder({0, 0, -1}, {0, 0, at + 1}, bore, 0.01);
    for (SolidPart& part : object.parts) part.solid = without(part.solid, hole);
  }
  return object;
}

/// A base with an upright plate, bosses and holes.
SolidObject bracket(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  object.blend = 0.01;
  const double thick = draw(0.06, 0.12);
  const Vector3d half(draw(0.5, 0.9), draw(0.3, 0.6), thick);
  Solid base = rounded_box({0, 0, 0}, half, 0.02);
  const double hole = draw(0.07, 0.12);
  for (const double side : {-1.0, 1.0}) {
    const Vector3d at(side * (half.x() - 2 * hole), half.y() - 2 * hole, 0);
    base = without(base, rounded_cylinder(at - Vector3d::UnitZ(), at + Vector3d::UnitZ(), hole, 0.01));
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
      boss =
          without(boss, rounded_cylinder(at + 0.2 * Vector3d::UnitZ(), at + 2 * Vector3d::UnitZ(), radius / 2, 0.01));
    }
    object.parts.push_back({2 + i, boss});
  }
  return object;
}

SolidObject aeroplane(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  const double girth = draw(0.1, 0.2);
  const double span = draw(0.7, 1.2);
  const double sweep = draw(0, 0.6);
  const double chord = draw(0.2, 0.34);
  const double thin = draw(0.2, 0.3);
  const double wing_height = draw(-0.6, 0.6) * girth;
  const double tail_height = draw.happens(0.3) ? 0.45 : 0.4 * girth;
  object.thinnest = 0.9 * thin * chord;
  object.parts.push_back({0, tube({{{1.1, 0, 0}, 0.4 * girth},
                                   {{0.85, 0, 0}, 0.9 * girth},
                                   {{0.2, 0, 0}, girth},
                                   {{-0.5, 0, 0}, girth},
                                   {{-1.1, 0, 0.3 * girth}, 0.35 * girth}})});
  const double tail_chord = 0.6 * chord;
  const int engines = draw.from(0, 2);
  const double engine = draw(0.06, 0.09);
  int label = 1;
  for (const double side : {-1.0, 1.0}) {
    object.parts.push_back(
        {label, tube({{{0.1, 0, wing_height}, chord}, {{0.1 - sweep, side * span, wing_height + 0.08}, 0.5 * chord}},
                     {0, 0, 1}, thin)});
    object.parts.push_back({label + 2, tube({{{-0.95, 0, tail_height}, tail_chord},
                                             {{-1.05 - 0.4 * sweep, side * 0.4 * span, tail_height}, 0.6 * tail_chord}},
                                            {0, 0, 1}, 1.3 * thin)});
    for (int i = 0; i < engines; ++i) {
      const double share = 0.35 + 0.3 * i;
      const Vector3d at(0.1 - share * sweep + 0.6 * chord, side * share * span, wing_height - engine + 0.08 * share);
      object.parts.push_back({6 + 2 * i + label - 1, tube({{at, engine}, {at - Vector3d(0.3, 0, 0), 0.7 * engine}})});
    }
    ++label;
  }
  object.parts.push_back({5, tube({{{-0.9, 0, 0.3 * girth}, 1.2 * tail_chord},
                                   {{-1.15, 0, 0.3 * girth + draw(0.35, 0.5)}, 0.7 * tail_chord}},
                                  {0, 1, 0}, 1.3 * thin)});
  return object;
}

SolidObject fish(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  const double tall = draw(0.25, 0.5);
  const double flat = draw(0.3, 0.7);
  const double fin = draw(0.16, 0.26);
  constexpr double fin_flatness = 0.25;
  object.thinnest = 0.08;
  object.parts.push_back({0, tube({{{0.9, 0, 0}, 0.3 * tall},
                                   {{0.6, 0, 0}, 0.75 * tall},
                                   {{0.15, 0, 0}, tall},
                                   {{-0.35, 0, 0}, 0.7 * tall},
                                   {{-0.75, 0, 0}, 0.28 * tall}},
                                  {0, 1, 0}, flat)});
  const double fork = draw(0, 0.4);
  for (const double side : {-1.0, 1.0}) {
    object.parts.push_back({1, tube({{{-0.75, 0, 0}, 0.12},
                                     {{-0.95, 0, 0.5 * side * (fork + 0.2)}, 0.15},
                                     {{-1.2, 0, side * (fork + 0.2)}, 0.1}},
                                    {0, 1, 0}, 0.4)});
  }
  const double long_fin = draw(0, 0.35);
  object.parts.push_back({2, tube({{{0.2, 0, 0.85 * tall}, fin},
                                   {{0.1 - long_fin, 0, 0.75 * tall + 0.7 * fin}, fin},
                                   {{-0.1 - long_fin, 0, 0.8 * tall + fin}, 0.5 * fin}},
                                  {0, 1, 0}, fin_flatness)});
  if (draw.happens(0.6)) {
    object.parts.push_back(
        {5,
         tube({{{-0.25, 0, -0.65 * tall}, 0.6 * fin}, {{-0.45, 0, -0.75 * tall - fin}, 0.5 * fin}}, {0, 1, 0}, 0.35)});
  }
  const double droop = draw(-0.3, 0.1);
  for (const double side : {-1.0, 1.0}) {
    object.parts.push_back(
        {side < 0 ? 3 : 4, tube({{{0.45, side * 0.7 * flat * tall, -0.2 * tall}, 0.6 * fin},
                                 {{0.15, side * (flat * tall + 0.3), -0.2 * tall + droop}, 0.5 * fin}},
                                {0, -0.3 * side, 1}, 0.35)});
  }
  return object;
}

SolidObject bust(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  object.blend = 0.06;
  const double head = draw(0.26, 0.34);
  const double neck = head * draw(0.45, 0.65);
  const double shoulders = draw(0.35, 0.6);
  const double depth = draw(0.45, 0.7);
  const double cut = draw(-0.7, -0.35);
  const double chest = draw(0.3, 0.45);
  const double neck_length = draw(0.15, 0.35);
  const Solid torso =
      tube({{{0, -shoulders, 0.05}, 0.75 * chest}, {{0, 0, 0}, 1.1 * chest}, {{0, shoulders, 0.05}, 0.75 * chest}},
           {1, 0, 0}, depth);
  const Solid chest_below =
      tube({{{0, 0, 0}, shoulders}, {{0, 0, cut - 0.6}, 0.8 * shoulders}}, {1, 0, 0}, 0.8 * depth * chest / shoulders);
  const Solid above = slab(cut, 10);
  object.parts.push_back({0, common(torso, above)});
  object.parts.push_back({0, common(chest_below, above)});
  const double top = 0.8 * chest + neck_length;
  const double forward = draw(0, 0.12);
  object.parts.push_back({1, tube({{{0, 0, 0.4 * chest}, 1.1 * neck}, {{forward, 0, top + 0.3 * head}, neck}})});
  const double face = draw(0.75, 0.95);
  object.parts.push_back(
      {2, tube({{{forward + 0.06, 0, top + 0.6 * head}, 0.8 * head}, {{forward, 0, top + 1.5 * head}, head}}, {0, 1, 0},
               face)});
  if (draw.happens(0.5)) {
    object.parts.push_back({2, tube({{{forward + head, 0, top + 1.1 * head}, 0.06},
                                     {{forward + 0.8 * head, 0, top + 1.5 * head}, 0.04}})});
  }
  if (draw.happens(0.5)) {
    const double width = draw(0.3, 0.5);
    const double height = draw(0.15, 0.35);
    object.parts.push_back({3, draw.happens(0.5)
                                   ? rounded_cylinder({0, 0, cut - height}, {0, 0, cut + 0.03}, width, 0.03)
                                   : rounded_box({0, 0, cut - height / 2}, {width, width, height / 2 + 0.03}, 0.03)});
  }
  return object;
}

SolidObject hammer(RandomNumbers& random) {
  Draw draw(random);
  SolidObject object;
  const double length = draw(1.2, 2);
  const double grip = draw(0.06, 0.11);
  object.parts.push_back(
      {0, tube({{{0, 0, 0}, grip * draw(0.9, 1.4)}, {{0, 0, 0.4 * length}, grip}, {{0, 0, length}, 0.9 * grip}},
               {1, 0, 0}, draw(0.7, 1))});
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

const std::array classes = {
    ObjectClass{"mug", {"vessel", "handle", "other handle"}, &mug},
    ObjectClass{"table",
                {"top", "leg 1", "leg 2", "leg 3", "leg 4", "column", "foot 1", "foot 2", "foot 3", "foot 4", "foot 5"},
                &table},
    ObjectClass{"aeroplane",
                {"fuselage", "wing right", "wing left", "tailplane right", "tailplane left", "fin",
                 "inner engine right", "inner engine left", "outer engine right", "outer engine left"},
                &aeroplane},
    ObjectClass{"vase", {"body", "neck", "foot", "handle", "other handle"}, &vase},
    ObjectClass{"chair",
                {"seat", "back", "leg 1", "leg 2", "leg 3", "leg 4", "arm right", "arm left", "column", "foot 1",
                 "foot 2", "foot 3", "foot 4", "foot 5"},
                &chair},
    ObjectClass{"spectacles", {"lens right", "lens left", "temple right", "temple left", "bridge"}, &spectacles},
    ObjectClass{"shaft", {"piece 1", "piece 2", "piece 3", "piece 4"}, &shaft},
    ObjectClass{
        "fish", {"body", "tail fin", "dorsal fin", "pectoral fin right", "pectoral fin left", "anal fin"}, &fish},
    ObjectClass{"teapot", {"body", "spout", "handle", "knob"}, &teapot},
    ObjectClass{"bracket", {"base", "plate", "boss", "other boss"}, &bracket},
    ObjectClass{"bust", {"torso", "neck", "head", "pedestal"}, &bust},
    ObjectClass{"hammer", {"handle", "head", "claw"}, &hammer}};

}  // namespace

std::span<const ObjectClass> object_classes() { return classes; }

}  // namespace shapegauge

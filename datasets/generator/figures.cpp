// SPDX-License-Identifier: GPL-3.0-or-later
// An aeroplane, a fish and a bust.

#include "shapegauge/datasets/generator/drawn_objects.h"

namespace shapegauge {

using Eigen::Vector3d;

SolidObject draw_aeroplane(RandomNumbers& random) {
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

SolidObject draw_fish(RandomNumbers& random) {
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

SolidObject draw_bust(RandomNumbers& random) {
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
  object.parts.push_back({0, intersection(torso, above)});
  object.parts.push_back({0, intersection(chest_below, above)});
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

}  // namespace shapegauge

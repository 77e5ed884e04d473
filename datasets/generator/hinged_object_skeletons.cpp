// SPDX-License-Identifier: GPL-3.0-or-later
// Skeletons of hinged objects in their rest pose.

#include <cmath>
#include <numbers>
#include <vector>

#include "shapegauge/datasets/generator/class_skeletons.h"

namespace shapegauge {

Skeleton glasses_skeleton() {
  Skeleton s{"glasses", {}};
  const int bridge = add_limb(
      s, {.kind = "bridge",
          .nodes = {{{0, 0.2, 0.05}, 0.05}, {{0, 0.07, 0.1}, 0.05}, {{0, -0.07, 0.1}, 0.05}, {{0, -0.2, 0.05}, 0.05}},
          .joints = {{1, {yaw_hinge(-5, 5), roll_hinge(-4, 4)}}}});
  std::vector<LimbNode> ring;
  constexpr int pieces = 16;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = 2 * std::numbers::pi * i / pieces;
    ring.push_back({{0, 0.56 - 0.38 * std::cos(angle), 0.3 * std::sin(angle)}, 0.055});
  }
  const int rim = add_limb_pair(s, {.kind = "rim", .parent = bridge, .nodes = ring, .blend = 0.6});
  add_limb_pair(
      s,
      {.kind = "temple",
       .parent = rim,
       .nodes = {{{-0.02, 0.96, 0.06}, 0.06},
                 {{-0.3, 0.99, 0.07}, 0.055},
                 {{-0.7, 0.99, 0.07}, 0.05},
                 {{-1.1, 0.97, 0.06}, 0.05},
                 {{-1.32, 0.96, -0.03}, 0.055},
                 {{-1.45, 0.95, -0.2}, 0.06}},
       .joints = {{0, {yaw_hinge(-25, 75), pitch_hinge(-6, 6)}}, {2, {yaw_hinge(-5, 8)}}, {3, {pitch_hinge(-15, 15)}}}},
      true);
  return s;
}

Skeleton lamp_skeleton() {
  Skeleton s{"lamp", {}};
  const int base = add_limb(s, {.kind = "base", .nodes = {{{0, 0, 0}, 0.5}, {{0, 0, 0.02}, 0.5}}, .flatness = 0.25});
  const int stem = add_limb(s, {.kind = "lower arm",
                                .parent = base,
                                .nodes = {{{0, 0, 0.08}, 0.09}, {{-0.18, 0, 0.45}, 0.06}, {{-0.4, 0, 0.92}, 0.07}},
                                .joints = {{0, {pitch_hinge(-18, 35), yaw_hinge(-60, 60)}}},
                                .blend = 0.9});
  const int upper =
      add_limb(s, {.kind = "upper arm",
                   .parent = stem,
                   .nodes = {{{-0.4, 0, 0.92}, 0.075}, {{-0.05, 0, 1.22}, 0.058}, {{0.32, 0, 1.52}, 0.065}},
                   .joints = {{0, {pitch_hinge(-38, 32)}}}});
  const int shade = add_limb(s, {.kind = "shade",
                                 .parent = upper,
                                 .nodes = {{{0.34, 0, 1.53}, 0.1}, {{0.43, 0, 1.44}, 0.15}, {{0.54, 0, 1.32}, 0.21}},
                                 .joints = {{0, {pitch_hinge(-55, 40), roll_hinge(-25, 25)}}}});
  add_limb(s, {.kind = "rim",
               .parent = shade,
               .nodes = {{{0.62, 0, 1.24}, 0.36}, {{0.63, 0, 1.23}, 0.36}},
               .blend = 0.6,
               .flat_axis = {0.68, 0, -0.73},
               .flatness = 0.25});
  return s;
}

Skeleton pliers_skeleton() {
  Skeleton s{"pliers", {}};
  const int pivot = add_limb(s, {.kind = "pivot", .nodes = {{{-0.1, 0, 0}, 0.2}, {{0.1, 0, 0}, 0.2}}, .flatness = 0.6});
  add_limb_pair(
      s, {.kind = "jaw",
          .parent = pivot,
          .nodes = {{{0.15, 0.1, 0}, 0.14}, {{0.4, 0.15, 0}, 0.12}, {{0.65, 0.14, 0}, 0.095}, {{0.92, 0.11, 0}, 0.06}},
          .joints = {{0, {yaw_hinge(-3, 28)}}},
          .blend = 0.3,
          .flatness = 0.8});
  add_limb_pair(s, {.kind = "handle",
                    .parent = pivot,
                    .nodes = {{{-0.12, 0.1, 0}, 0.11},
                              {{-0.4, 0.26, 0}, 0.095},
                              {{-0.8, 0.36, 0}, 0.1},
                              {{-1.2, 0.36, 0}, 0.1},
                              {{-1.55, 0.3, 0}, 0.085}},
                    .joints = {{0, {yaw_hinge(-30, 9)}}, {2, {yaw_hinge(-6, 6)}}},
                    .flatness = 0.75});
  return s;
}

}  // namespace shapegauge

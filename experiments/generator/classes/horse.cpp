#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

Skeleton horse() {
  Skeleton s{"horse", {}};
  const int body = add_limb(
      s, {.kind = "body",
          .nodes = {{{-0.8, 0, 0.06}, 0.33}, {{-0.35, 0, 0}, 0.36}, {{0.15, 0, 0}, 0.36}, {{0.6, 0, 0.08}, 0.34}},
          .joints = joints_along(1, 2, {pitch(-7, 7), yaw(-10, 10)}),
          .flat_axis = {0, 1, 0},
          .flatness = 0.85});
  const int neck = add_limb(
      s, {.kind = "neck",
          .parent = body,
          .nodes = {{{0.72, 0, 0.25}, 0.27}, {{0.95, 0, 0.58}, 0.21}, {{1.15, 0, 0.88}, 0.16}, {{1.28, 0, 1.1}, 0.14}},
          .joints = joints_along(0, 2, {pitch(-8, 24), yaw(-15, 15)}),
          .flat_axis = {0, 1, 0},
          .flatness = 0.7});
  const int head = add_limb(
      s, {.kind = "head",
          .parent = neck,
          .nodes = {{{1.32, 0, 1.16}, 0.15}, {{1.46, 0, 1.06}, 0.155}, {{1.64, 0, 0.86}, 0.115}, {{1.8, 0, 0.68}, 0.1}},
          .joints = {{0, {pitch(-25, 25), yaw(-20, 20)}}},
          .flat_axis = {0, 1, 0},
          .flatness = 0.8});
  add_limb_pair(s, {.kind = "ear",
                    .parent = head,
                    .nodes = {{{1.27, 0.06, 1.26}, 0.055}, {{1.26, 0.09, 1.38}, 0.05}, {{1.27, 0.1, 1.48}, 0.03}},
                    .blend = 0.4});
  add_limb_pair(s, {.kind = "front leg",
                    .parent = body,
                    .nodes = {{{0.58, 0.16, -0.1}, 0.2},
                              {{0.6, 0.19, -0.5}, 0.12},
                              {{0.6, 0.19, -0.9}, 0.075},
                              {{0.6, 0.19, -1.32}, 0.06},
                              {{0.65, 0.19, -1.52}, 0.08}},
                    .joints = {{0, {pitch(-45, 35), roll(-3, 6)}}, {2, {pitch(-2, 75)}}, {3, {pitch(-10, 30)}}}});
  add_limb_pair(s, {.kind = "hind leg",
                    .parent = body,
                    .nodes = {{{-0.8, 0.15, -0.05}, 0.26},
                              {{-0.72, 0.19, -0.5}, 0.16},
                              {{-0.95, 0.19, -0.9}, 0.085},
                              {{-0.92, 0.19, -1.32}, 0.065},
                              {{-0.87, 0.19, -1.52}, 0.08}},
                    .joints = {{0, {pitch(-40, 35), roll(-3, 6)}}, {2, {pitch(-45, 15)}}, {3, {pitch(-10, 30)}}}});
  add_limb(s, {.kind = "tail",
               .parent = body,
               .nodes = {{{-1.05, 0, 0.22}, 0.09},
                         {{-1.26, 0, 0.16}, 0.09},
                         {{-1.4, 0, -0.06}, 0.1},
                         {{-1.46, 0, -0.32}, 0.09},
                         {{-1.48, 0, -0.56}, 0.05}},
               .joints = joints_along(0, 3, {pitch(-10, 20), yaw(-16, 16)}),
               .curls = true});
  return s;
}

}  // namespace shapegauge

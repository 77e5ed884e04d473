#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

Skeleton bird() {
  Skeleton s{"bird", {}};
  const int body = add_limb(
      s, {.kind = "body",
          .nodes = {{{-0.65, 0, 0}, 0.14}, {{-0.3, 0, 0}, 0.24}, {{0.1, 0, 0}, 0.28}, {{0.42, 0, 0.05}, 0.2}}});
  add_limb(
      s, {.kind = "head",
          .parent = body,
          .nodes = {{{0.5, 0, 0.1}, 0.15}, {{0.68, 0, 0.22}, 0.16}, {{0.84, 0, 0.24}, 0.12}, {{1.08, 0, 0.19}, 0.045}},
          .joints = {{0, {pitch(-25, 25), yaw(-30, 30)}}, {1, {yaw(-25, 25), pitch(-20, 20)}}}});
  const Hinge flap = roll(-38, 42);
  add_limb_pair(s, {.kind = "wing",
                    .parent = body,
                    .nodes = {{{0.12, 0.15, 0.1}, 0.24},
                              {{0.14, 0.5, 0.15}, 0.27},
                              {{0.12, 0.9, 0.19}, 0.27},
                              {{0.02, 1.3, 0.2}, 0.23},
                              {{-0.12, 1.65, 0.19}, 0.17},
                              {{-0.28, 1.92, 0.17}, 0.1}},
                    .joints = {{0, {flap, yaw(-18, 15)}},
                               {2, {roll(-32, 25), yaw(-22, 6)}},
                               {3, {roll(-25, 25)}},
                               {4, {roll(-20, 20)}}},
                    .blend = 0.35,
                    .flat_axis = {0, -0.08, 1},
                    .flatness = 0.32});
  add_limb(s, {.kind = "tail",
               .parent = body,
               .nodes = {{{-0.65, 0, 0}, 0.14}, {{-0.9, 0, 0}, 0.19}, {{-1.25, 0, 0}, 0.28}},
               .joints = {{0, {pitch(-25, 25), yaw(-15, 15)}}, {1, {pitch(-15, 15)}}},
               .flatness = 0.25});
  add_limb_pair(s, {.kind = "foot",
                    .parent = body,
                    .nodes = {{{-0.25, 0.1, -0.15}, 0.08}, {{-0.34, 0.12, -0.36}, 0.05}, {{-0.5, 0.13, -0.5}, 0.06}},
                    .joints = {{0, {pitch(-30, 35)}}, {1, {pitch(-30, 30)}}}});
  return s;
}

}  // namespace shapegauge

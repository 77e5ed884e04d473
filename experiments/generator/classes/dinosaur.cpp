#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

// A two-legged one, with a heavy tail and small arms.
Skeleton dinosaur() {
  Skeleton s{"dinosaur", {}};
  const int body = add_limb(
      s, {.kind = "body",
          .nodes = {{{-0.4, 0, 0}, 0.3}, {{-0.05, 0, 0.08}, 0.36}, {{0.3, 0, 0.2}, 0.33}, {{0.55, 0, 0.36}, 0.26}},
          .joints = {{1, {pitch(-12, 12), yaw(-10, 10)}}, {2, {pitch(-10, 10), yaw(-12, 12)}}},
          .flat_axis = {0, 1, 0},
          .flatness = 0.85});
  const int neck = add_limb(s, {.kind = "neck",
                                .parent = body,
                                .nodes = {{{0.6, 0, 0.42}, 0.22}, {{0.78, 0, 0.66}, 0.17}, {{0.9, 0, 0.88}, 0.16}},
                                .joints = joints_along(0, 1, {pitch(-15, 20), yaw(-20, 20)})});
  add_limb(s, {.kind = "head",
               .parent = neck,
               .nodes = {{{0.9, 0, 0.98}, 0.2}, {{1.1, 0, 1.0}, 0.22}, {{1.35, 0, 0.95}, 0.16}, {{1.58, 0, 0.9}, 0.11}},
               .joints = {{0, {pitch(-20, 25), yaw(-25, 25)}}},
               .flat_axis = {0, 1, 0},
               .flatness = 0.8});
  add_limb_pair(s, {.kind = "arm",
                    .parent = body,
                    .nodes = {{{0.55, 0.2, 0.2}, 0.08},
                              {{0.62, 0.27, 0.0}, 0.062},
                              {{0.78, 0.27, -0.12}, 0.055},
                              {{0.9, 0.26, -0.14}, 0.05}},
                    .joints = {{0, {pitch(-30, 35), roll(-8, 18)}}, {1, {pitch(-40, 35)}}, {2, {pitch(-25, 25)}}}});
  add_limb_pair(
      s,
      {.kind = "leg",
       .parent = body,
       .nodes = {{{-0.25, 0.2, -0.05}, 0.27},
                 {{-0.1, 0.27, -0.4}, 0.19},
                 {{0.02, 0.28, -0.65}, 0.12},
                 {{-0.2, 0.29, -0.98}, 0.085},
                 {{-0.1, 0.29, -1.25}, 0.085},
                 {{0.08, 0.3, -1.32}, 0.09},
                 {{0.26, 0.31, -1.34}, 0.06}},
       .joints = {
           {0, {pitch(-35, 35), roll(-4, 10)}}, {2, {pitch(-25, 35)}}, {3, {pitch(-30, 25)}}, {4, {pitch(-20, 20)}}}});
  add_limb(s, {.kind = "tail",
               .parent = body,
               .nodes = {{{-0.55, 0, -0.02}, 0.27},
                         {{-0.85, 0, -0.08}, 0.22},
                         {{-1.15, 0, -0.12}, 0.17},
                         {{-1.45, 0, -0.12}, 0.125},
                         {{-1.75, 0, -0.08}, 0.085},
                         {{-2.0, 0, -0.02}, 0.045}},
               .joints = joints_along(0, 4, {pitch(-15, 15), yaw(-22, 22)}),
               .curls = true});
  return s;
}

}  // namespace shapegauge

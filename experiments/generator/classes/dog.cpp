#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

Skeleton dog() {
  Skeleton s{"dog", {}};
  const int body = add_limb(
      s, {.kind = "body",
          .nodes = {{{-0.95, 0, 0}, 0.27}, {{-0.45, 0, 0.02}, 0.25}, {{0.1, 0, -0.02}, 0.29}, {{0.65, 0, 0.03}, 0.33}},
          .joints = joints_along(1, 2, {pitch(-8, 9), yaw(-18, 18)})});
  const int neck = add_limb(s, {.kind = "neck",
                                .parent = body,
                                .nodes = {{{0.7, 0, 0.1}, 0.24}, {{0.95, 0, 0.4}, 0.18}, {{1.08, 0, 0.62}, 0.17}},
                                .joints = joints_along(0, 1, {pitch(-10, 28), yaw(-25, 25)})});
  const int head = add_limb(
      s, {.kind = "head",
          .parent = neck,
          .nodes = {{{1.05, 0, 0.72}, 0.2}, {{1.22, 0, 0.72}, 0.19}, {{1.42, 0, 0.63}, 0.12}, {{1.68, 0, 0.57}, 0.09}},
          .joints = {{0, {pitch(-20, 25), yaw(-25, 25), roll(-15, 15)}}}});
  add_limb_pair(s, {.kind = "ear",
                    .parent = head,
                    .nodes = {{{1.02, 0.12, 0.82}, 0.1}, {{0.98, 0.19, 0.98}, 0.085}, {{0.97, 0.22, 1.12}, 0.04}},
                    .blend = 0.4,
                    .flat_axis = {1, 0.3, 0.2},
                    .flatness = 0.6});
  add_limb_pair(s, {.kind = "front leg",
                    .parent = body,
                    .nodes = {{{0.62, 0.17, -0.05}, 0.2},
                              {{0.6, 0.21, -0.45}, 0.115},
                              {{0.62, 0.21, -0.85}, 0.075},
                              {{0.64, 0.21, -1.12}, 0.075},
                              {{0.76, 0.21, -1.18}, 0.07}},
                    .joints = {{0, {pitch(-38, 38), roll(-6, 12)}}, {1, {pitch(-2, 50)}}, {2, {pitch(-10, 40)}}}});
  add_limb_pair(s, {.kind = "hind leg",
                    .parent = body,
                    .nodes = {{{-0.9, 0.16, -0.05}, 0.23},
                              {{-0.82, 0.21, -0.45}, 0.14},
                              {{-1.05, 0.21, -0.8}, 0.08},
                              {{-0.98, 0.21, -1.12}, 0.075},
                              {{-0.86, 0.21, -1.18}, 0.07}},
                    .joints = {{0, {pitch(-40, 38), roll(-6, 12)}}, {1, {pitch(-20, 40)}}, {2, {pitch(-45, 15)}}}});
  add_limb(s, {.kind = "tail",
               .parent = body,
               .nodes = {{{-1.1, 0, 0.12}, 0.1},
                         {{-1.35, 0, 0.22}, 0.075},
                         {{-1.58, 0, 0.36}, 0.065},
                         {{-1.76, 0, 0.54}, 0.055},
                         {{-1.9, 0, 0.74}, 0.045}},
               .joints = joints_along(0, 3, {pitch(-20, 25), yaw(-28, 28)}),
               .curls = true});
  return s;
}

}  // namespace shapegauge

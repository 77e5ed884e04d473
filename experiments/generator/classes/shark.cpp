#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

Skeleton shark() {
  Skeleton s{"shark", {}};
  const int body = add_limb(s, {.kind = "body",
                                .nodes = {{{1.35, 0, 0.02}, 0.08},
                                          {{1.05, 0, 0.02}, 0.23},
                                          {{0.6, 0, 0}, 0.34},
                                          {{0.1, 0, 0}, 0.36},
                                          {{-0.4, 0, 0}, 0.29},
                                          {{-0.85, 0, 0}, 0.19},
                                          {{-1.25, 0, 0.02}, 0.12},
                                          {{-1.5, 0, 0.04}, 0.1}},
                                .joints = joints_along(2, 6, {yaw(-24, 24), pitch(-7, 7)}),
                                .curls = true,
                                .flat_axis = {0, 1, 0},
                                .flatness = 0.8});
  add_limb(s, {.kind = "dorsal fin",
               .parent = body,
               .nodes = {{{0.1, 0, 0.26}, 0.24}, {{-0.02, 0, 0.48}, 0.15}, {{-0.14, 0, 0.68}, 0.07}},
               .blend = 0.3,
               .flat_axis = {0, 1, 0},
               .flatness = 0.3});
  add_limb_pair(s, {.kind = "pectoral fin",
                    .parent = body,
                    .nodes = {{{0.5, 0.2, -0.14}, 0.2}, {{0.34, 0.5, -0.24}, 0.16}, {{0.14, 0.78, -0.32}, 0.08}},
                    .joints = {{0, {roll(-22, 30), yaw(-15, 18)}}, {1, {roll(-18, 18)}}},
                    .blend = 0.3,
                    .flat_axis = {0, 0.35, 1},
                    .flatness = 0.3});
  add_limb(s, {.kind = "upper tail fin",
               .parent = body,
               .nodes = {{{-1.45, 0, 0.06}, 0.12}, {{-1.66, 0, 0.3}, 0.13}, {{-1.86, 0, 0.6}, 0.06}},
               .joints = {{0, {yaw(-20, 20)}}},
               .flat_axis = {0, 1, 0},
               .flatness = 0.42});
  add_limb(s, {.kind = "lower tail fin",
               .parent = body,
               .nodes = {{{-1.45, 0, 0.02}, 0.11}, {{-1.58, 0, -0.16}, 0.11}, {{-1.68, 0, -0.34}, 0.06}},
               .joints = {{0, {yaw(-20, 20)}}},
               .flat_axis = {0, 1, 0},
               .flatness = 0.42});
  return s;
}

}  // namespace shapegauge

#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

Skeleton flamingo() {
  Skeleton s{"flamingo", {}};
  const int body = add_limb(
      s, {.kind = "body",
          .nodes = {{{-0.75, 0, 0.0}, 0.09}, {{-0.45, 0, 0.02}, 0.22}, {{-0.1, 0, 0.02}, 0.31}, {{0.2, 0, 0.06}, 0.25}},
          .joints = {{1, {pitch(-15, 15)}}},
          .flat_axis = {0, 1, 0},
          .flatness = 0.85});
  const int neck = add_limb(s, {.kind = "neck",
                                .parent = body,
                                .nodes = {{{0.3, 0, 0.1}, 0.13},
                                          {{0.52, 0, 0.2}, 0.088},
                                          {{0.66, 0, 0.4}, 0.075},
                                          {{0.68, 0, 0.64}, 0.07},
                                          {{0.64, 0, 0.88}, 0.066},
                                          {{0.66, 0, 1.12}, 0.064},
                                          {{0.76, 0, 1.32}, 0.066}},
                                .joints = joints_along(0, 5, {pitch(-22, 22), yaw(-14, 14)}),
                                .curls = true});
  add_limb(s,
           {.kind = "head",
            .parent = neck,
            .nodes = {{{0.8, 0, 1.38}, 0.08}, {{0.92, 0, 1.4}, 0.105}, {{1.06, 0, 1.34}, 0.07}, {{1.16, 0, 1.2}, 0.05}},
            .joints = {{0, {pitch(-25, 40), yaw(-30, 30)}}}});
  add_limb_pair(s, {.kind = "leg",
                    .parent = body,
                    .nodes = {{{-0.1, 0.12, -0.18}, 0.12},
                              {{-0.06, 0.14, -0.45}, 0.06},
                              {{-0.04, 0.14, -0.8}, 0.05},
                              {{-0.1, 0.15, -1.15}, 0.042},
                              {{-0.12, 0.15, -1.5}, 0.045},
                              {{0.0, 0.15, -1.57}, 0.05},
                              {{0.14, 0.15, -1.58}, 0.04}},
                    .joints = {{0, {pitch(-40, 35), roll(-3, 8)}}, {2, {pitch(-60, 5)}}, {4, {pitch(-10, 35)}}}});
  return s;
}

}  // namespace shapegauge

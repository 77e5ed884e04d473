#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

Skeleton octopus() {
  Skeleton s{"octopus", {}};
  const int head = add_limb(
      s, {.kind = "head",
          .nodes = {{{0, 0, -0.05}, 0.3}, {{0, 0, 0.2}, 0.27}, {{-0.05, 0, 0.55}, 0.4}, {{-0.12, 0, 0.85}, 0.34}},
          .joints = {{1, {pitch(-25, 20), roll(-20, 20)}}}});
  const Limb arm{.kind = "arm",
                 .parent = head,
                 .nodes = {{{0.2, 0, -0.12}, 0.15},
                           {{0.5, 0, -0.2}, 0.125},
                           {{0.78, 0, -0.24}, 0.105},
                           {{1.05, 0, -0.24}, 0.088},
                           {{1.3, 0, -0.22}, 0.073},
                           {{1.54, 0, -0.2}, 0.06},
                           {{1.76, 0, -0.18}, 0.048},
                           {{1.95, 0, -0.17}, 0.036}},
                 .joints = joints_along(1, 6, {pitch(-26, 26), yaw(-24, 24)}),
                 .curls = true};
  for (int i = 0; i < 8; ++i) add_limb(s, turned(arm, 22.5 + 45 * i, std::to_string(i + 1)));
  return s;
}

}  // namespace shapegauge

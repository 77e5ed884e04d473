#include <cmath>
#include <numbers>

#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

Skeleton glasses() {
  Skeleton s{"glasses", {}};
  const int bridge = add_limb(
      s, {.kind = "bridge",
          .nodes = {{{0, 0.2, 0.05}, 0.05}, {{0, 0.07, 0.1}, 0.05}, {{0, -0.07, 0.1}, 0.05}, {{0, -0.2, 0.05}, 0.05}},
          .joints = {{1, {yaw(-5, 5), roll(-4, 4)}}}});
  std::vector<LimbNode> ring;
  constexpr int pieces = 16;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = 2 * std::numbers::pi * i / pieces;
    ring.push_back({{0, 0.56 - 0.38 * std::cos(angle), 0.3 * std::sin(angle)}, 0.055});
  }
  const int rim = add_limb_pair(s, {.kind = "rim", .parent = bridge, .nodes = ring, .blend = 0.6});
  add_limb_pair(s,
                {.kind = "temple",
                 .parent = rim,
                 .nodes = {{{-0.02, 0.96, 0.06}, 0.06},
                           {{-0.3, 0.99, 0.07}, 0.055},
                           {{-0.7, 0.99, 0.07}, 0.05},
                           {{-1.1, 0.97, 0.06}, 0.05},
                           {{-1.32, 0.96, -0.03}, 0.055},
                           {{-1.45, 0.95, -0.2}, 0.06}},
                 .joints = {{0, {yaw(-25, 75), pitch(-6, 6)}}, {2, {yaw(-5, 8)}}, {3, {pitch(-15, 15)}}}},
                true);
  return s;
}

}  // namespace shapegauge

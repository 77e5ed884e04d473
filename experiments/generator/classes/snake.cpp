#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

Skeleton snake() {
  Skeleton s{"snake", {}};
  std::vector<LimbNode> nodes;
  for (int i = 0; i <= 16; ++i) {
    const double t = i / 16.0;
    nodes.push_back({{2.8 * (0.5 - t), 0, 0}, t < 0.45 ? 0.065 + 0.045 * t / 0.45 : 0.11 - 0.085 * (t - 0.45) / 0.55});
  }
  const int body = add_limb(
      s, {.kind = "body", .nodes = nodes, .joints = joints_along(1, 15, {yaw(-36, 36), pitch(-8, 8)}), .curls = true});
  add_limb(s, {.kind = "head",
               .parent = body,
               .nodes = {{{1.4, 0, 0}, 0.07}, {{1.52, 0, 0.01}, 0.115}, {{1.65, 0, 0}, 0.1}, {{1.78, 0, -0.01}, 0.06}},
               .joints = {{0, {pitch(-30, 20), yaw(-25, 25)}}},
               .flatness = 0.7});
  return s;
}

}  // namespace shapegauge

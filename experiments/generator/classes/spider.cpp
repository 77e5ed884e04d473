#include <array>
#include <cstddef>

#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

Skeleton spider() {
  Skeleton s{"spider", {}};
  const int thorax = add_limb(s, {.kind = "thorax",
                                  .nodes = {{{-0.2, 0, 0}, 0.19}, {{0.05, 0, 0.02}, 0.25}, {{0.3, 0, 0}, 0.17}},
                                  .flatness = 0.7});
  add_limb(
      s,
      {.kind = "abdomen",
       .parent = thorax,
       .nodes = {{{-0.28, 0, 0.02}, 0.1}, {{-0.5, 0, 0.08}, 0.26}, {{-0.85, 0, 0.12}, 0.42}, {{-1.15, 0, 0.08}, 0.26}},
       .joints = {{0, {pitch(-25, 20), yaw(-22, 22)}}},
       .blend = 0.6});
  for (int pair = 0; pair < 4; ++pair) {
    const Eigen::Vector3d out =
        Eigen::Vector3d(std::array{0.75, 0.28, -0.25, -0.8}[static_cast<std::size_t>(pair)], 1, 0).normalized();
    const Eigen::Vector3d root(0.28 - 0.15 * pair, 0.12, 0);
    const auto at = [&](double reach, double height) -> Eigen::Vector3d {
      return root + reach * out + Eigen::Vector3d(0, 0, height);
    };
    const Eigen::Vector3d up(0, 0, 1);
    add_limb_pair(s, {.kind = "leg",
                      .side = std::to_string(pair + 1),
                      .parent = thorax,
                      .nodes = {{at(0, 0), 0.075},
                                {at(0.3, 0.16), 0.065},
                                {at(0.62, 0.42), 0.055},
                                {at(0.9, 0.22), 0.045},
                                {at(1.18, -0.25), 0.04},
                                {at(1.42, -0.68), 0.033}},
                      .joints = {{0, {hinge({0, 0, 1}, -13, 13), hinge_towards(out, up, -22, 22)}},
                                 {2, {hinge_towards(out, up, -38, 30)}},
                                 {4, {hinge_towards(out, up, -35, 35)}}}});
  }
  add_limb_pair(s, {.kind = "palp",
                    .parent = thorax,
                    .nodes = {{{0.4, 0.07, 0}, 0.055}, {{0.56, 0.13, 0.06}, 0.05}, {{0.72, 0.14, -0.05}, 0.04}},
                    .joints = {{0, {yaw(-12, 12)}}, {1, {pitch(-30, 30)}}}});
  return s;
}

}  // namespace shapegauge

#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

namespace {

void add_legs(Skeleton& s, int thorax) {
  const Eigen::Vector3d up(0, 0, 1);
  int pair = 0;
  for (const double forward : {0.8, -0.1, -0.95}) {
    const Eigen::Vector3d out = Eigen::Vector3d(forward, 1, 0).normalized();
    const Eigen::Vector3d root(0.16 - 0.17 * pair, 0.07, -0.06);
    const auto at = [&](double reach, double height) -> Eigen::Vector3d {
      return root + reach * out + Eigen::Vector3d(0, 0, height);
    };
    add_limb_pair(s, {.kind = "leg",
                      .side = std::to_string(++pair),
                      .parent = thorax,
                      .nodes = {{at(0, 0), 0.055},
                                {at(0.22, 0.06), 0.05},
                                {at(0.45, 0.14), 0.045},
                                {at(0.66, -0.16), 0.04},
                                {at(0.86, -0.46), 0.035},
                                {at(1.04, -0.52), 0.035}},
                      .joints = {{0, {yaw(-18, 18), hinge_towards(out, up, -18, 18)}},
                                 {2, {hinge_towards(out, up, -30, 35)}},
                                 {4, {hinge_towards(out, up, -30, 20)}}}});
  }
}

}  // namespace

Skeleton ant() {
  Skeleton s{"ant", {}};
  const int thorax = add_limb(
      s, {.kind = "thorax", .nodes = {{{-0.3, 0, 0.02}, 0.1}, {{-0.05, 0, 0.02}, 0.14}, {{0.2, 0, 0.04}, 0.17}}});
  add_limb(s, {.kind = "abdomen",
               .parent = thorax,
               .nodes = {{{-0.4, 0, 0.03}, 0.07},
                         {{-0.58, 0, 0.1}, 0.17},
                         {{-0.85, 0, 0.15}, 0.29},
                         {{-1.12, 0, 0.1}, 0.25},
                         {{-1.36, 0, 0}, 0.1}},
               .joints = {{0, {pitch(-30, 25), yaw(-25, 25)}}}});
  const int head = add_limb(s, {.kind = "head",
                                .parent = thorax,
                                .nodes = {{{0.32, 0, 0.04}, 0.08}, {{0.5, 0, 0.06}, 0.2}, {{0.72, 0, 0}, 0.17}},
                                .joints = {{0, {pitch(-20, 25), yaw(-25, 25)}}},
                                .flatness = 0.85});
  add_limb_pair(s, {.kind = "antenna",
                    .parent = head,
                    .nodes = {{{0.7, 0.07, 0.1}, 0.045},
                              {{0.85, 0.22, 0.28}, 0.036},
                              {{0.98, 0.36, 0.42}, 0.034},
                              {{1.2, 0.44, 0.4}, 0.034},
                              {{1.42, 0.5, 0.34}, 0.034}},
                    .joints = {{0, {yaw(-20, 20), pitch(-20, 20)}}, {2, {pitch(-30, 35), yaw(-20, 20)}}}});
  add_legs(s, thorax);
  return s;
}

}  // namespace shapegauge

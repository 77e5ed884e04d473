#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

namespace {

void add_legs(Skeleton& s, int shell) {
  const Eigen::Vector3d up(0, 0, 1);
  int pair = 0;
  for (const double forward : {0.35, -0.05, -0.5}) {
    const Eigen::Vector3d out = Eigen::Vector3d(forward, 1, 0).normalized();
    const Eigen::Vector3d root(0.16 - 0.2 * pair, 0.5 - 0.05 * pair, -0.04);
    const auto at = [&](double reach, double height) -> Eigen::Vector3d {
      return root + reach * out + Eigen::Vector3d(0, 0, height);
    };
    add_limb_pair(s, {.kind = "leg",
                      .side = std::to_string(++pair),
                      .parent = shell,
                      .nodes = {{at(0, 0), 0.08},
                                {at(0.26, 0.1), 0.075},
                                {at(0.46, 0.08), 0.065},
                                {at(0.64, -0.14), 0.052},
                                {at(0.74, -0.4), 0.035}},
                      .joints = {{0, {yaw(-10, 10), hinge_towards(out, up, -20, 20)}},
                                 {2, {hinge_towards(out, up, -30, 35)}},
                                 {3, {hinge_towards(out, up, -25, 25)}}}});
  }
}

}  // namespace

Skeleton crab() {
  Skeleton s{"crab", {}};
  const int shell =
      add_limb(s, {.kind = "shell",
                   .nodes = {{{0, 0.3, 0}, 0.38}, {{0, 0.1, 0}, 0.44}, {{0, -0.1, 0}, 0.44}, {{0, -0.3, 0}, 0.38}},
                   .flatness = 0.5});
  const int arm =
      add_limb_pair(s, {.kind = "arm",
                        .parent = shell,
                        .nodes = {{{0.26, 0.42, 0}, 0.1},
                                  {{0.46, 0.68, 0.02}, 0.085},
                                  {{0.62, 0.86, 0.03}, 0.085},
                                  {{0.86, 0.78, 0.03}, 0.1}},
                        .joints = {{0, {yaw(-15, 20), pitch(-15, 15)}}, {2, {yaw(-18, 35), pitch(-15, 20)}}}});
  add_limb_pair(s,
                {.kind = "claw",
                 .parent = arm,
                 .nodes = {{{0.9, 0.78, 0.03}, 0.1},
                           {{1.08, 0.8, 0.03}, 0.17},
                           {{1.3, 0.84, 0.03}, 0.11},
                           {{1.52, 0.76, 0.03}, 0.05}},
                 .joints = {{0, {yaw(-20, 20)}}},
                 .flatness = 0.7},
                true);
  add_limb_pair(s,
                {.kind = "pincer",
                 .parent = arm + 2,
                 .nodes = {{{1.12, 0.68, 0.03}, 0.09}, {{1.28, 0.6, 0.03}, 0.07}, {{1.46, 0.6, 0.03}, 0.045}},
                 .joints = {{0, {yaw(-15, 12)}}},
                 .blend = 0.3,
                 .flatness = 0.8},
                true);
  add_legs(s, shell);
  add_limb_pair(s, {.kind = "eye",
                    .parent = shell,
                    .nodes = {{{0.38, 0.12, 0.08}, 0.05}, {{0.45, 0.14, 0.26}, 0.045}, {{0.46, 0.14, 0.34}, 0.06}},
                    .joints = {{0, {pitch(-15, 15)}}}});
  return s;
}

}  // namespace shapegauge

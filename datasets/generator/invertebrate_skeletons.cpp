// SPDX-License-Identifier: GPL-3.0-or-later
// Skeletons of animals without bones, in their rest pose.

#include <array>
#include <cstddef>
#include <string>

#include "shapegauge/datasets/generator/class_skeletons.h"

namespace shapegauge {

namespace {

void add_ant_legs(Skeleton& s, int thorax) {
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
                      .joints = {{0, {yaw_hinge(-18, 18), hinge_towards(out, up, -18, 18)}},
                                 {2, {hinge_towards(out, up, -30, 35)}},
                                 {4, {hinge_towards(out, up, -30, 20)}}}});
  }
}

}  // namespace

Skeleton ant_skeleton() {
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
               .joints = {{0, {pitch_hinge(-30, 25), yaw_hinge(-25, 25)}}}});
  const int head = add_limb(s, {.kind = "head",
                                .parent = thorax,
                                .nodes = {{{0.32, 0, 0.04}, 0.08}, {{0.5, 0, 0.06}, 0.2}, {{0.72, 0, 0}, 0.17}},
                                .joints = {{0, {pitch_hinge(-20, 25), yaw_hinge(-25, 25)}}},
                                .flatness = 0.85});
  add_limb_pair(s, {.kind = "antenna",
                    .parent = head,
                    .nodes = {{{0.7, 0.07, 0.1}, 0.045},
                              {{0.85, 0.22, 0.28}, 0.036},
                              {{0.98, 0.36, 0.42}, 0.034},
                              {{1.2, 0.44, 0.4}, 0.034},
                              {{1.42, 0.5, 0.34}, 0.034}},
                    .joints = {{0, {yaw_hinge(-20, 20), pitch_hinge(-20, 20)}},
                               {2, {pitch_hinge(-30, 35), yaw_hinge(-20, 20)}}}});
  add_ant_legs(s, thorax);
  return s;
}

namespace {

void add_crab_legs(Skeleton& s, int shell) {
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
                      .joints = {{0, {yaw_hinge(-10, 10), hinge_towards(out, up, -20, 20)}},
                                 {2, {hinge_towards(out, up, -30, 35)}},
                                 {3, {hinge_towards(out, up, -25, 25)}}}});
  }
}

}  // namespace

Skeleton crab_skeleton() {
  Skeleton s{"crab", {}};
  const int shell =
      add_limb(s, {.kind = "shell",
                   .nodes = {{{0, 0.3, 0}, 0.38}, {{0, 0.1, 0}, 0.44}, {{0, -0.1, 0}, 0.44}, {{0, -0.3, 0}, 0.38}},
                   .flatness = 0.5});
  const int arm = add_limb_pair(s, {.kind = "arm",
                                    .parent = shell,
                                    .nodes = {{{0.26, 0.42, 0}, 0.1},
                                              {{0.46, 0.68, 0.02}, 0.085},
                                              {{0.62, 0.86, 0.03}, 0.085},
                                              {{0.86, 0.78, 0.03}, 0.1}},
                                    .joints = {{0, {yaw_hinge(-15, 20), pitch_hinge(-15, 15)}},
                                               {2, {yaw_hinge(-18, 35), pitch_hinge(-15, 20)}}}});
  add_limb_pair(s,
                {.kind = "claw",
                 .parent = arm,
                 .nodes = {{{0.9, 0.78, 0.03}, 0.1},
                           {{1.08, 0.8, 0.03}, 0.17},
                           {{1.3, 0.84, 0.03}, 0.11},
                           {{1.52, 0.76, 0.03}, 0.05}},
                 .joints = {{0, {yaw_hinge(-20, 20)}}},
                 .flatness = 0.7},
                true);
  add_limb_pair(s,
                {.kind = "pincer",
                 .parent = arm + 2,
                 .nodes = {{{1.12, 0.68, 0.03}, 0.09}, {{1.28, 0.6, 0.03}, 0.07}, {{1.46, 0.6, 0.03}, 0.045}},
                 .joints = {{0, {yaw_hinge(-15, 12)}}},
                 .blend = 0.3,
                 .flatness = 0.8},
                true);
  add_crab_legs(s, shell);
  add_limb_pair(s, {.kind = "eye",
                    .parent = shell,
                    .nodes = {{{0.38, 0.12, 0.08}, 0.05}, {{0.45, 0.14, 0.26}, 0.045}, {{0.46, 0.14, 0.34}, 0.06}},
                    .joints = {{0, {pitch_hinge(-15, 15)}}}});
  return s;
}

Skeleton octopus_skeleton() {
  Skeleton s{"octopus", {}};
  const int head = add_limb(
      s, {.kind = "head",
          .nodes = {{{0, 0, -0.05}, 0.3}, {{0, 0, 0.2}, 0.27}, {{-0.05, 0, 0.55}, 0.4}, {{-0.12, 0, 0.85}, 0.34}},
          .joints = {{1, {pitch_hinge(-25, 20), roll_hinge(-20, 20)}}}});
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
                 .joints = joints_along(1, 6, {pitch_hinge(-26, 26), yaw_hinge(-24, 24)}),
                 .curls = true};
  for (int i = 0; i < 8; ++i) add_limb(s, turned(arm, 22.5 + 45 * i, std::to_string(i + 1)));
  return s;
}

Skeleton spider_skeleton() {
  Skeleton s{"spider", {}};
  const int thorax = add_limb(s, {.kind = "thorax",
                                  .nodes = {{{-0.2, 0, 0}, 0.19}, {{0.05, 0, 0.02}, 0.25}, {{0.3, 0, 0}, 0.17}},
                                  .flatness = 0.7});
  add_limb(
      s,
      {.kind = "abdomen",
       .parent = thorax,
       .nodes = {{{-0.28, 0, 0.02}, 0.1}, {{-0.5, 0, 0.08}, 0.26}, {{-0.85, 0, 0.12}, 0.42}, {{-1.15, 0, 0.08}, 0.26}},
       .joints = {{0, {pitch_hinge(-25, 20), yaw_hinge(-22, 22)}}},
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
                    .joints = {{0, {yaw_hinge(-12, 12)}}, {1, {pitch_hinge(-30, 30)}}}});
  return s;
}

}  // namespace shapegauge

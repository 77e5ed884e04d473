// SPDX-License-Identifier: GPL-3.0-or-later
// Skeletons of animals with bones, and of a hand, in their rest pose.

#include <string>
#include <vector>

#include "shapegauge/datasets/generator/class_skeletons.h"

namespace shapegauge {

Skeleton bird_skeleton() {
  Skeleton s{"bird", {}};
  const int body = add_limb(
      s, {.kind = "body",
          .nodes = {{{-0.65, 0, 0}, 0.14}, {{-0.3, 0, 0}, 0.24}, {{0.1, 0, 0}, 0.28}, {{0.42, 0, 0.05}, 0.2}}});
  add_limb(
      s,
      {.kind = "head",
       .parent = body,
       .nodes = {{{0.5, 0, 0.1}, 0.15}, {{0.68, 0, 0.22}, 0.16}, {{0.84, 0, 0.24}, 0.12}, {{1.08, 0, 0.19}, 0.045}},
       .joints = {{0, {pitch_hinge(-25, 25), yaw_hinge(-30, 30)}}, {1, {yaw_hinge(-25, 25), pitch_hinge(-20, 20)}}}});
  const Hinge flap = roll_hinge(-38, 42);
  add_limb_pair(s, {.kind = "wing",
                    .parent = body,
                    .nodes = {{{0.12, 0.15, 0.1}, 0.24},
                              {{0.14, 0.5, 0.15}, 0.27},
                              {{0.12, 0.9, 0.19}, 0.27},
                              {{0.02, 1.3, 0.2}, 0.23},
                              {{-0.12, 1.65, 0.19}, 0.17},
                              {{-0.28, 1.92, 0.17}, 0.1}},
                    .joints = {{0, {flap, yaw_hinge(-18, 15)}},
                               {2, {roll_hinge(-32, 25), yaw_hinge(-22, 6)}},
                               {3, {roll_hinge(-25, 25)}},
                               {4, {roll_hinge(-20, 20)}}},
                    .blend = 0.35,
                    .flat_axis = {0, -0.08, 1},
                    .flatness = 0.32});
  add_limb(s, {.kind = "tail",
               .parent = body,
               .nodes = {{{-0.65, 0, 0}, 0.14}, {{-0.9, 0, 0}, 0.19}, {{-1.25, 0, 0}, 0.28}},
               .joints = {{0, {pitch_hinge(-25, 25), yaw_hinge(-15, 15)}}, {1, {pitch_hinge(-15, 15)}}},
               .flatness = 0.25});
  add_limb_pair(s, {.kind = "foot",
                    .parent = body,
                    .nodes = {{{-0.25, 0.1, -0.15}, 0.08}, {{-0.34, 0.12, -0.36}, 0.05}, {{-0.5, 0.13, -0.5}, 0.06}},
                    .joints = {{0, {pitch_hinge(-30, 35)}}, {1, {pitch_hinge(-30, 30)}}}});
  return s;
}

// Two-legged, with a heavy tail and small arms.
Skeleton dinosaur_skeleton() {
  Skeleton s{"dinosaur", {}};
  const int body = add_limb(
      s, {.kind = "body",
          .nodes = {{{-0.4, 0, 0}, 0.3}, {{-0.05, 0, 0.08}, 0.36}, {{0.3, 0, 0.2}, 0.33}, {{0.55, 0, 0.36}, 0.26}},
          .joints = {{1, {pitch_hinge(-12, 12), yaw_hinge(-10, 10)}}, {2, {pitch_hinge(-10, 10), yaw_hinge(-12, 12)}}},
          .flat_axis = {0, 1, 0},
          .flatness = 0.85});
  const int neck = add_limb(s, {.kind = "neck",
                                .parent = body,
                                .nodes = {{{0.6, 0, 0.42}, 0.22}, {{0.78, 0, 0.66}, 0.17}, {{0.9, 0, 0.88}, 0.16}},
                                .joints = joints_along(0, 1, {pitch_hinge(-15, 20), yaw_hinge(-20, 20)})});
  add_limb(s, {.kind = "head",
               .parent = neck,
               .nodes = {{{0.9, 0, 0.98}, 0.2}, {{1.1, 0, 1.0}, 0.22}, {{1.35, 0, 0.95}, 0.16}, {{1.58, 0, 0.9}, 0.11}},
               .joints = {{0, {pitch_hinge(-20, 25), yaw_hinge(-25, 25)}}},
               .flat_axis = {0, 1, 0},
               .flatness = 0.8});
  add_limb_pair(s, {.kind = "arm",
                    .parent = body,
                    .nodes = {{{0.55, 0.2, 0.2}, 0.08},
                              {{0.62, 0.27, 0.0}, 0.062},
                              {{0.78, 0.27, -0.12}, 0.055},
                              {{0.9, 0.26, -0.14}, 0.05}},
                    .joints = {{0, {pitch_hinge(-30, 35), roll_hinge(-8, 18)}},
                               {1, {pitch_hinge(-40, 35)}},
                               {2, {pitch_hinge(-25, 25)}}}});
  add_limb_pair(s, {.kind = "leg",
                    .parent = body,
                    .nodes = {{{-0.25, 0.2, -0.05}, 0.27},
                              {{-0.1, 0.27, -0.4}, 0.19},
                              {{0.02, 0.28, -0.65}, 0.12},
                              {{-0.2, 0.29, -0.98}, 0.085},
                              {{-0.1, 0.29, -1.25}, 0.085},
                              {{0.08, 0.3, -1.32}, 0.09},
                              {{0.26, 0.31, -1.34}, 0.06}},
                    .joints = {{0, {pitch_hinge(-35, 35), roll_hinge(-4, 10)}},
                               {2, {pitch_hinge(-25, 35)}},
                               {3, {pitch_hinge(-30, 25)}},
                               {4, {pitch_hinge(-20, 20)}}}});
  add_limb(s, {.kind = "tail",
               .parent = body,
               .nodes = {{{-0.55, 0, -0.02}, 0.27},
                         {{-0.85, 0, -0.08}, 0.22},
                         {{-1.15, 0, -0.12}, 0.17},
                         {{-1.45, 0, -0.12}, 0.125},
                         {{-1.75, 0, -0.08}, 0.085},
                         {{-2.0, 0, -0.02}, 0.045}},
               .joints = joints_along(0, 4, {pitch_hinge(-15, 15), yaw_hinge(-22, 22)}),
               .curls = true});
  return s;
}

Skeleton dog_skeleton() {
  Skeleton s{"dog", {}};
  const int body = add_limb(
      s, {.kind = "body",
          .nodes = {{{-0.95, 0, 0}, 0.27}, {{-0.45, 0, 0.02}, 0.25}, {{0.1, 0, -0.02}, 0.29}, {{0.65, 0, 0.03}, 0.33}},
          .joints = joints_along(1, 2, {pitch_hinge(-8, 9), yaw_hinge(-18, 18)})});
  const int neck = add_limb(s, {.kind = "neck",
                                .parent = body,
                                .nodes = {{{0.7, 0, 0.1}, 0.24}, {{0.95, 0, 0.4}, 0.18}, {{1.08, 0, 0.62}, 0.17}},
                                .joints = joints_along(0, 1, {pitch_hinge(-10, 28), yaw_hinge(-25, 25)})});
  const int head = add_limb(
      s, {.kind = "head",
          .parent = neck,
          .nodes = {{{1.05, 0, 0.72}, 0.2}, {{1.22, 0, 0.72}, 0.19}, {{1.42, 0, 0.63}, 0.12}, {{1.68, 0, 0.57}, 0.09}},
          .joints = {{0, {pitch_hinge(-20, 25), yaw_hinge(-25, 25), roll_hinge(-15, 15)}}}});
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
                    .joints = {{0, {pitch_hinge(-38, 38), roll_hinge(-6, 12)}},
                               {1, {pitch_hinge(-2, 50)}},
                               {2, {pitch_hinge(-10, 40)}}}});
  add_limb_pair(s, {.kind = "hind leg",
                    .parent = body,
                    .nodes = {{{-0.9, 0.16, -0.05}, 0.23},
                              {{-0.82, 0.21, -0.45}, 0.14},
                              {{-1.05, 0.21, -0.8}, 0.08},
                              {{-0.98, 0.21, -1.12}, 0.075},
                              {{-0.86, 0.21, -1.18}, 0.07}},
                    .joints = {{0, {pitch_hinge(-40, 38), roll_hinge(-6, 12)}},
                               {1, {pitch_hinge(-20, 40)}},
                               {2, {pitch_hinge(-45, 15)}}}});
  add_limb(s, {.kind = "tail",
               .parent = body,
               .nodes = {{{-1.1, 0, 0.12}, 0.1},
                         {{-1.35, 0, 0.22}, 0.075},
                         {{-1.58, 0, 0.36}, 0.065},
                         {{-1.76, 0, 0.54}, 0.055},
                         {{-1.9, 0, 0.74}, 0.045}},
               .joints = joints_along(0, 3, {pitch_hinge(-20, 25), yaw_hinge(-28, 28)}),
               .curls = true});
  return s;
}

Skeleton flamingo_skeleton() {
  Skeleton s{"flamingo", {}};
  const int body = add_limb(
      s, {.kind = "body",
          .nodes = {{{-0.75, 0, 0.0}, 0.09}, {{-0.45, 0, 0.02}, 0.22}, {{-0.1, 0, 0.02}, 0.31}, {{0.2, 0, 0.06}, 0.25}},
          .joints = {{1, {pitch_hinge(-15, 15)}}},
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
                                .joints = joints_along(0, 5, {pitch_hinge(-22, 22), yaw_hinge(-14, 14)}),
                                .curls = true});
  add_limb(s,
           {.kind = "head",
            .parent = neck,
            .nodes = {{{0.8, 0, 1.38}, 0.08}, {{0.92, 0, 1.4}, 0.105}, {{1.06, 0, 1.34}, 0.07}, {{1.16, 0, 1.2}, 0.05}},
            .joints = {{0, {pitch_hinge(-25, 40), yaw_hinge(-30, 30)}}}});
  add_limb_pair(s, {.kind = "leg",
                    .parent = body,
                    .nodes = {{{-0.1, 0.12, -0.18}, 0.12},
                              {{-0.06, 0.14, -0.45}, 0.06},
                              {{-0.04, 0.14, -0.8}, 0.05},
                              {{-0.1, 0.15, -1.15}, 0.042},
                              {{-0.12, 0.15, -1.5}, 0.045},
                              {{0.0, 0.15, -1.57}, 0.05},
                              {{0.14, 0.15, -1.58}, 0.04}},
                    .joints = {{0, {pitch_hinge(-40, 35), roll_hinge(-3, 8)}},
                               {2, {pitch_hinge(-60, 5)}},
                               {4, {pitch_hinge(-10, 35)}}}});
  return s;
}

namespace {

void add_human_arms(Skeleton& s, int torso) {
  const Eigen::Vector3d forward(1, 0, 0);
  const Eigen::Vector3d arm(0, 0.82, -0.57);
  const Eigen::Vector3d up(0, 0.57, 0.82);
  add_limb_pair(s, {.kind = "arm",
                    .parent = torso,
                    .nodes = {{{0, 0.26, 0.8}, 0.125},
                              {{0, 0.49, 0.64}, 0.1},
                              {{0, 0.7, 0.5}, 0.078},
                              {{0, 0.92, 0.345}, 0.072},
                              {{0, 1.1, 0.22}, 0.052},
                              {{0.01, 1.2, 0.15}, 0.068},
                              {{0.02, 1.34, 0.05}, 0.05}},
                    .joints = {{0, {hinge_towards(arm, up, -25, 55), hinge_towards(arm, forward, -35, 65)}},
                               {2, {hinge_towards(arm, forward, 0, 110)}},
                               {4, {hinge_towards(arm, up, -30, 30)}}}});
}

Limb tail_fin(const std::string& kind, int body, const std::vector<LimbNode>& nodes) {
  return {.kind = kind,
          .parent = body,
          .nodes = nodes,
          .joints = {{0, {yaw_hinge(-20, 20)}}},
          .flat_axis = {0, 1, 0},
          .flatness = 0.42};
}

// Makes a finger from its knuckle, in a direction in the plane of the palm; z is the back of the hand.
Limb finger(const std::string& kind, int palm, const Eigen::Vector3d& knuckle, const Eigen::Vector3d& direction,
            double length, double radius) {
  const Eigen::Vector3d down(0, 0, -1);
  const Eigen::Vector3d along = direction.normalized();
  const auto at = [&](double fraction) -> Eigen::Vector3d { return knuckle + fraction * length * along; };
  const Hinge bend = hinge_towards(along, down, -4, 75);
  return {.kind = kind,
          .parent = palm,
          .nodes = {{at(0), radius}, {at(0.42), 0.97 * radius}, {at(0.7), 0.9 * radius}, {at(1), 0.8 * radius}},
          .joints = {{0, {hinge_towards(along, down, -12, 80), hinge({0, 0, 1}, -7, 7)}}, {1, {bend}}, {2, {bend}}},
          .curls = true,
          .blend = 0.35};
}

}  // namespace

Skeleton hand_skeleton() {
  Skeleton s{"hand", {}};
  const int palm =
      add_limb(s, {.kind = "palm",
                   .nodes = {{{-0.55, 0, 0}, 0.27}, {{-0.2, 0, 0}, 0.36}, {{0.15, 0, 0}, 0.42}, {{0.4, 0, 0}, 0.4}},
                   .flat_axis = {0, 0, 1},
                   .flatness = 0.42});
  add_limb(s, {.kind = "wrist",
               .parent = palm,
               .nodes = {{{-0.6, 0, 0}, 0.25}, {{-0.9, 0, 0}, 0.23}, {{-1.3, 0, 0}, 0.26}},
               .joints = {{0, {pitch_hinge(-40, 40), yaw_hinge(-20, 20)}}},
               .flat_axis = {0, 0, 1},
               .flatness = 0.72});
  add_limb(s, finger("index finger", palm, {0.58, 0.36, 0}, {1, 0.22, 0}, 0.86, 0.115));
  add_limb(s, finger("middle finger", palm, {0.66, 0.12, 0}, {1, 0.06, 0}, 0.96, 0.118));
  add_limb(s, finger("ring finger", palm, {0.62, -0.13, 0}, {1, -0.1, 0}, 0.88, 0.11));
  add_limb(s, finger("little finger", palm, {0.5, -0.36, 0}, {1, -0.28, 0}, 0.7, 0.095));
  const Eigen::Vector3d along = Eigen::Vector3d(0.62, 0.78, -0.1).normalized();
  const Eigen::Vector3d across(0.55, -0.5, -0.6);
  add_limb(s, {.kind = "thumb",
               .parent = palm,
               .nodes = {{{-0.3, 0.22, -0.02}, 0.17},
                         {{-0.06, 0.52, -0.06}, 0.14},
                         {{0.14, 0.77, -0.09}, 0.125},
                         {{0.34, 1.0, -0.12}, 0.1}},
               .joints = {{0, {hinge_towards(along, across, -10, 25)}},
                          {1, {hinge_towards(along, across, -10, 40)}},
                          {2, {hinge_towards(along, across, -5, 55)}}},
               .blend = 0.6});
  return s;
}

Skeleton horse_skeleton() {
  Skeleton s{"horse", {}};
  const int body = add_limb(
      s, {.kind = "body",
          .nodes = {{{-0.8, 0, 0.06}, 0.33}, {{-0.35, 0, 0}, 0.36}, {{0.15, 0, 0}, 0.36}, {{0.6, 0, 0.08}, 0.34}},
          .joints = joints_along(1, 2, {pitch_hinge(-7, 7), yaw_hinge(-10, 10)}),
          .flat_axis = {0, 1, 0},
          .flatness = 0.85});
  const int neck = add_limb(
      s, {.kind = "neck",
          .parent = body,
          .nodes = {{{0.72, 0, 0.25}, 0.27}, {{0.95, 0, 0.58}, 0.21}, {{1.15, 0, 0.88}, 0.16}, {{1.28, 0, 1.1}, 0.14}},
          .joints = joints_along(0, 2, {pitch_hinge(-8, 24), yaw_hinge(-15, 15)}),
          .flat_axis = {0, 1, 0},
          .flatness = 0.7});
  const int head = add_limb(
      s, {.kind = "head",
          .parent = neck,
          .nodes = {{{1.32, 0, 1.16}, 0.15}, {{1.46, 0, 1.06}, 0.155}, {{1.64, 0, 0.86}, 0.115}, {{1.8, 0, 0.68}, 0.1}},
          .joints = {{0, {pitch_hinge(-25, 25), yaw_hinge(-20, 20)}}},
          .flat_axis = {0, 1, 0},
          .flatness = 0.8});
  add_limb_pair(s, {.kind = "ear",
                    .parent = head,
                    .nodes = {{{1.27, 0.06, 1.26}, 0.055}, {{1.26, 0.09, 1.38}, 0.05}, {{1.27, 0.1, 1.48}, 0.03}},
                    .blend = 0.4});
  add_limb_pair(s, {.kind = "front leg",
                    .parent = body,
                    .nodes = {{{0.58, 0.16, -0.1}, 0.2},
                              {{0.6, 0.19, -0.5}, 0.12},
                              {{0.6, 0.19, -0.9}, 0.075},
                              {{0.6, 0.19, -1.32}, 0.06},
                              {{0.65, 0.19, -1.52}, 0.08}},
                    .joints = {{0, {pitch_hinge(-45, 35), roll_hinge(-3, 6)}},
                               {2, {pitch_hinge(-2, 75)}},
                               {3, {pitch_hinge(-10, 30)}}}});
  add_limb_pair(s, {.kind = "hind leg",
                    .parent = body,
                    .nodes = {{{-0.8, 0.15, -0.05}, 0.26},
                              {{-0.72, 0.19, -0.5}, 0.16},
                              {{-0.95, 0.19, -0.9}, 0.085},
                              {{-0.92, 0.19, -1.32}, 0.065},
                              {{-0.87, 0.19, -1.52}, 0.08}},
                    .joints = {{0, {pitch_hinge(-40, 35), roll_hinge(-3, 6)}},
                               {2, {pitch_hinge(-45, 15)}},
                               {3, {pitch_hinge(-10, 30)}}}});
  add_limb(s, {.kind = "tail",
               .parent = body,
               .nodes = {{{-1.05, 0, 0.22}, 0.09},
                         {{-1.26, 0, 0.16}, 0.09},
                         {{-1.4, 0, -0.06}, 0.1},
                         {{-1.46, 0, -0.32}, 0.09},
                         {{-1.48, 0, -0.56}, 0.05}},
               .joints = joints_along(0, 3, {pitch_hinge(-10, 20), yaw_hinge(-16, 16)}),
               .curls = true});
  return s;
}

Skeleton human_skeleton() {
  Skeleton s{"human", {}};
  const int torso =
      add_limb(s, {.kind = "torso",
                   .nodes = {{{0, 0, -0.05}, 0.26}, {{0, 0, 0.25}, 0.23}, {{0, 0, 0.55}, 0.27}, {{0, 0, 0.78}, 0.25}},
                   .joints = joints_along(1, 2, {pitch_hinge(-10, 25), yaw_hinge(-20, 20), roll_hinge(-15, 15)}),
                   .flat_axis = {1, 0, 0},
                   .flatness = 0.68});
  add_limb(s, {.kind = "head",
               .parent = torso,
               .nodes = {{{0, 0, 0.9}, 0.11}, {{0.01, 0, 1.1}, 0.1}, {{0.03, 0, 1.26}, 0.17}, {{0.03, 0, 1.4}, 0.16}},
               .joints = {{0, {pitch_hinge(-10, 20), yaw_hinge(-20, 20)}},
                          {1, {pitch_hinge(-15, 20), yaw_hinge(-40, 40), roll_hinge(-20, 20)}}}});
  add_human_arms(s, torso);
  add_limb_pair(s, {.kind = "leg",
                    .parent = torso,
                    .nodes = {{{0, 0.14, -0.12}, 0.165},
                              {{0.01, 0.19, -0.4}, 0.145},
                              {{0.02, 0.23, -0.75}, 0.095},
                              {{-0.01, 0.25, -0.98}, 0.1},
                              {{0, 0.28, -1.36}, 0.065},
                              {{0.1, 0.3, -1.42}, 0.07},
                              {{0.24, 0.32, -1.43}, 0.05}},
                    .joints = {{0, {pitch_hinge(-75, 25), roll_hinge(-5, 28)}},
                               {2, {pitch_hinge(0, 100)}},
                               {4, {pitch_hinge(-25, 20)}}}});
  return s;
}

Skeleton shark_skeleton() {
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
                                .joints = joints_along(2, 6, {yaw_hinge(-24, 24), pitch_hinge(-7, 7)}),
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
                    .joints = {{0, {roll_hinge(-22, 30), yaw_hinge(-15, 18)}}, {1, {roll_hinge(-18, 18)}}},
                    .blend = 0.3,
                    .flat_axis = {0, 0.35, 1},
                    .flatness = 0.3});
  add_limb(s, tail_fin("upper tail fin", body,
                       {{{-1.45, 0, 0.06}, 0.12}, {{-1.66, 0, 0.3}, 0.13}, {{-1.86, 0, 0.6}, 0.06}}));
  add_limb(s, tail_fin("lower tail fin", body,
                       {{{-1.45, 0, 0.02}, 0.11}, {{-1.58, 0, -0.16}, 0.11}, {{-1.68, 0, -0.34}, 0.06}}));
  return s;
}

Skeleton snake_skeleton() {
  Skeleton s{"snake", {}};
  std::vector<LimbNode> nodes;
  for (int i = 0; i <= 16; ++i) {
    const double t = i / 16.0;
    nodes.push_back({{2.8 * (0.5 - t), 0, 0}, t < 0.45 ? 0.065 + 0.045 * t / 0.45 : 0.11 - 0.085 * (t - 0.45) / 0.55});
  }
  const int body = add_limb(s, {.kind = "body",
                                .nodes = nodes,
                                .joints = joints_along(1, 15, {yaw_hinge(-36, 36), pitch_hinge(-8, 8)}),
                                .curls = true});
  add_limb(s, {.kind = "head",
               .parent = body,
               .nodes = {{{1.4, 0, 0}, 0.07}, {{1.52, 0, 0.01}, 0.115}, {{1.65, 0, 0}, 0.1}, {{1.78, 0, -0.01}, 0.06}},
               .joints = {{0, {pitch_hinge(-30, 20), yaw_hinge(-25, 25)}}},
               .flatness = 0.7});
  return s;
}

}  // namespace shapegauge

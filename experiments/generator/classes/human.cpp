#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

Skeleton human() {
  Skeleton s{"human", {}};
  const int torso =
      add_limb(s, {.kind = "torso",
                   .nodes = {{{0, 0, -0.05}, 0.26}, {{0, 0, 0.25}, 0.23}, {{0, 0, 0.55}, 0.27}, {{0, 0, 0.78}, 0.25}},
                   .joints = joints_along(1, 2, {pitch(-10, 25), yaw(-20, 20), roll(-15, 15)}),
                   .flat_axis = {1, 0, 0},
                   .flatness = 0.68});
  add_limb(s, {.kind = "head",
               .parent = torso,
               .nodes = {{{0, 0, 0.9}, 0.11}, {{0.01, 0, 1.1}, 0.1}, {{0.03, 0, 1.26}, 0.17}, {{0.03, 0, 1.4}, 0.16}},
               .joints = {{0, {pitch(-10, 20), yaw(-20, 20)}}, {1, {pitch(-15, 20), yaw(-40, 40), roll(-20, 20)}}}});
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
  add_limb_pair(s, {.kind = "leg",
                    .parent = torso,
                    .nodes = {{{0, 0.14, -0.12}, 0.165},
                              {{0.01, 0.19, -0.4}, 0.145},
                              {{0.02, 0.23, -0.75}, 0.095},
                              {{-0.01, 0.25, -0.98}, 0.1},
                              {{0, 0.28, -1.36}, 0.065},
                              {{0.1, 0.3, -1.42}, 0.07},
                              {{0.24, 0.32, -1.43}, 0.05}},
                    .joints = {{0, {pitch(-75, 25), roll(-5, 28)}}, {2, {pitch(0, 100)}}, {4, {pitch(-25, 20)}}}});
  return s;
}

}  // namespace shapegauge

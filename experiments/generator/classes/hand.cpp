#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

namespace {

// A finger from its knuckle, in a direction in the plane of the palm; z is the back of the hand.
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

Skeleton hand() {
  Skeleton s{"hand", {}};
  const int palm =
      add_limb(s, {.kind = "palm",
                   .nodes = {{{-0.55, 0, 0}, 0.27}, {{-0.2, 0, 0}, 0.36}, {{0.15, 0, 0}, 0.42}, {{0.4, 0, 0}, 0.4}},
                   .flat_axis = {0, 0, 1},
                   .flatness = 0.42});
  add_limb(s, {.kind = "wrist",
               .parent = palm,
               .nodes = {{{-0.6, 0, 0}, 0.25}, {{-0.9, 0, 0}, 0.23}, {{-1.3, 0, 0}, 0.26}},
               .joints = {{0, {pitch(-40, 40), yaw(-20, 20)}}},
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

}  // namespace shapegauge

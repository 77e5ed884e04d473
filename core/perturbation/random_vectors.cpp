#include "shapegauge/core/perturbation/random_vectors.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace shapegauge {

namespace {

/// Two independent normal numbers.
Eigen::Vector2d gaussian_pair(RandomNumbers& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform(0, 1)));  // never the logarithm of 0
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

Eigen::Vector3d gaussian_vector(RandomNumbers& random) {
  const Eigen::Vector2d first = gaussian_pair(random);
  const Eigen::Vector2d second = gaussian_pair(random);
  return {first[0], first[1], second[0]};
}

Eigen::Vector3d point_in_unit_ball(RandomNumbers& random) {
  for (;;) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const double z = random.uniform(-1, 1);
    if (x * x + y * y + z * z <= 1) return {x, y, z};
  }
}

Eigen::Matrix3d uniform_rotation(RandomNumbers& random) {
  const double u = random.uniform(0, 1);
  const double first = random.uniform(0, 2 * std::numbers::pi);
  const double second = random.uniform(0, 2 * std::numbers::pi);
  return Eigen::Quaterniond(std::sqrt(u) * std::cos(second), std::sqrt(1 - u) * std::sin(first),
                            std::sqrt(1 - u) * std::cos(first), std::sqrt(u) * std::sin(second))
      .normalized()
      .toRotationMatrix();
}

}  // namespace shapegauge

#include "shapegauge/core/spatial/exposed_direction.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "shapegauge/core/spatial/offset_tolerance.h"

namespace shapegauge {

namespace {

/// Whether p + r u lies outside of the offset solid.
class Exposure {
 public:
  Exposure(const OffsetExterior& exterior, const Eigen::Vector3d& p) : exterior_(exterior), p_(p) {}

  [[nodiscard]] Eigen::Vector3d end(const Eigen::Vector3d& u) const {
    return p_ + exterior_.r() * (1 + offset_slack) * u;
  }

  bool at(const Eigen::Vector3d& u) {
    const auto covering = exterior_.tree().any_within(end(u), exterior_.r(), hint_);
    if (covering) hint_ = *covering;
    return !covering;
  }

 private:
  const OffsetExterior& exterior_;
  const Eigen::Vector3d& p_;
  std::int32_t hint_ = -1;  ///< what covered one direction often covers the next
};

/// Sum of the exposed directions on rings about the axis, each for the solid angle that it stands for.
Eigen::Vector3d sum_of_exposed(Exposure& exposure, const Eigen::Vector3d& axis) {
  constexpr int rings = 4;
  constexpr int directions_per_ring = 8;
  constexpr double step = std::numbers::pi / 12;
  const Eigen::Vector3d side = axis.unitOrthogonal();
  const Eigen::Vector3d other_side = axis.cross(side);
  // Solid angles in units of 2 pi: a cap about the axis, and the directions' shares of the rings.
  Eigen::Vector3d sum = (1 - std::cos(step / 2)) * axis;
  for (int ring = 1; ring <= rings; ++ring) {
    const double polar = ring * step;
    for (int k = 0; k < directions_per_ring; ++k) {
      const double around = 2 * std::numbers::pi * (k + 0.5 * (ring % 2)) / directions_per_ring;
      const Eigen::Vector3d u =
          std::cos(polar) * axis + std::sin(polar) * (std::cos(around) * side + std::sin(around) * other_side);
      if (exposure.at(u)) sum += 2 * std::sin(polar) * std::sin(step / 2) / directions_per_ring * u;
    }
  }
  return sum;
}

}  // namespace

Eigen::Vector3d middle_of_exposed(const OffsetExterior& exterior, const Eigen::Vector3d& p,
                                  const Eigen::Vector3d& direction) {
  constexpr int rounds = 2;
  Exposure exposure(exterior, p);
  Eigen::Vector3d middle = direction;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::Vector3d next = sum_of_exposed(exposure, middle).normalized();
    if (!exposure.at(next) || exterior.contains(exposure.end(next)) != true) break;
    middle = next;
  }
  return middle;
}

}  // namespace shapegauge

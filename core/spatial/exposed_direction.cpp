#include "shapegauge/core/spatial/exposed_direction.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shapegauge/core/spatial/offset_tolerance.h"

namespace shapegauge {

namespace {

/// A direction and the solid angle that it stands for, in units of 2 pi.
struct Direction {
  Eigen::Vector3d u;
  double weight;
};

/// The axis and four rings of eight directions about it, 15 degrees apart.
std::vector<Direction> directions_about(const Eigen::Vector3d& axis) {
  constexpr int rings = 4;
  constexpr int directions_per_ring = 8;
  constexpr double step = std::numbers::pi / 12;
  const Eigen::Vector3d side = axis.unitOrthogonal();
  const Eigen::Vector3d other_side = axis.cross(side);
  std::vector<Direction> directions{{axis, 1 - std::cos(step / 2)}};
  for (int ring = 1; ring <= rings; ++ring) {
    const double polar = ring * step;
    for (int k = 0; k < directions_per_ring; ++k) {
      const double around = 2 * std::numbers::pi * (k + 0.5 * (ring % 2)) / directions_per_ring;
      const Eigen::Vector3d across = std::cos(around) * side + std::sin(around) * other_side;
      directions.push_back({std::cos(polar) * axis + std::sin(polar) * across,
                            2 * std::sin(polar) * std::sin(step / 2) / directions_per_ring});
    }
  }
  return directions;
}

/// What the ball about a point looks out on.
class Exposure {
 public:
  Exposure(const OffsetExterior& exterior, const Eigen::Vector3d& p) : exterior_(exterior), p_(p) {}

  /// Whether the direction leads out of the offset solid.
  bool at(const Eigen::Vector3d& u) {
    const auto covering = exterior_.tree().any_within(end(u), exterior_.r(), hint_);
    if (covering) hint_ = *covering;
    return !covering;
  }

  [[nodiscard]] bool to_exterior(const Eigen::Vector3d& u) const { return exterior_.contains(end(u)) == true; }

 private:
  [[nodiscard]] Eigen::Vector3d end(const Eigen::Vector3d& u) const {
    return p_ + exterior_.r() * (1 + offset_slack) * u;
  }

  const OffsetExterior& exterior_;
  const Eigen::Vector3d& p_;
  std::int32_t hint_ = -1;  ///< what covered one direction often covers the next
};

/// The middle of what is exposed about the axis, or the exposed direction closest to it.
std::optional<Eigen::Vector3d> middle_about(Exposure& exposure, const Eigen::Vector3d& axis) {
  std::vector<Direction> exposed = directions_about(axis);
  std::erase_if(exposed, [&](const Direction& direction) { return !exposure.at(direction.u); });
  if (exposed.empty()) return std::nullopt;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Direction& direction : exposed) sum += direction.weight * direction.u;
  const Eigen::Vector3d middle = sum.normalized();
  if (exposure.at(middle)) return middle;
  return std::ranges::max_element(exposed, {}, [&](const Direction& direction) { return direction.u.dot(middle); })->u;
}

}  // namespace

std::optional<Eigen::Vector3d> middle_of_exposed(const OffsetExterior& exterior, const Eigen::Vector3d& p,
                                                 const Eigen::Vector3d& axis) {
  Exposure exposure(exterior, p);
  const auto first = middle_about(exposure, axis);
  if (!first || !exposure.to_exterior(*first)) return std::nullopt;
  const auto second = middle_about(exposure, *first);
  return second && exposure.to_exterior(*second) ? second : first;
}

}  // namespace shapegauge

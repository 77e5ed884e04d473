#include "tests/oracle/half_spaces.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace shapegauge {

namespace {

/// Planes whose normals enclose an angle with a smaller sine have no trustworthy common line.
constexpr double smallest_sine = 1e-4;

/// The problem of one call. Each step has one plane more that the answer is known to lie on.
struct Problem {
  std::span<const HalfSpace> half_spaces;
  double slack;  ///< a point this far outside of a half-space counts as in it

  [[nodiscard]] double depth(std::size_t i, const Eigen::Vector3d& x) const {
    return half_spaces[i].bound - half_spaces[i].normal.dot(x);
  }

  /// The point closest to `foot` on the line, along the unit vector, that is in the first `count` half-spaces.
  [[nodiscard]] std::optional<Eigen::Vector3d> on_line(const Eigen::Vector3d& foot, const Eigen::Vector3d& along,
                                                       std::size_t count) const {
    double low = -std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t i = 0; i < count; ++i) {
      const double slope = half_spaces[i].normal.dot(along);
      const double missing = depth(i, foot);
      if (std::abs(slope) < smallest_sine) {
        if (missing > slack) return std::nullopt;
      } else if (slope > 0) {
        low = std::max(low, missing / slope);
      } else {
        high = std::min(high, missing / slope);
      }
    }
    if (low > high + slack) return std::nullopt;
    return foot + std::min(std::max(0.0, low), high) * along;
  }

  /// The point closest to `foot` on the plane of half-space `plane` that is in those before it.
  [[nodiscard]] std::optional<Eigen::Vector3d> on_plane(const Eigen::Vector3d& foot, std::size_t plane) const {
    const Eigen::Vector3d& normal = half_spaces[plane].normal;
    Eigen::Vector3d x = foot;
    for (std::size_t i = 0; i < plane; ++i) {
      if (!(depth(i, x) > slack)) continue;
      const Eigen::Vector3d within = half_spaces[i].normal - half_spaces[i].normal.dot(normal) * normal;
      const double sine = within.norm();
      if (sine < smallest_sine) return std::nullopt;
      const Eigen::Vector3d towards = within / sine;
      const auto found = on_line(foot + depth(i, foot) / sine * towards, normal.cross(towards), i);
      if (!found) return std::nullopt;
      x = *found;
    }
    return x;
  }
};

}  // namespace

std::optional<Eigen::Vector3d> closest_point_in(std::span<const HalfSpace> half_spaces, const Eigen::Vector3d& p) {
  // Half-space after half-space: where one leaves out the closest point of those before it, the new one is on its
  // plane; the same holds in the plane for lines, and on a line (Seidel's algorithm, without the shuffling).
  double deepest = 0;
  for (const HalfSpace& half_space : half_spaces) {
    deepest = std::max(deepest, half_space.bound - half_space.normal.dot(p));
  }
  const Problem problem{half_spaces, 1e-9 * deepest};
  Eigen::Vector3d x = p;
  for (std::size_t i = 0; i < half_spaces.size(); ++i) {
    if (!(problem.depth(i, x) > problem.slack)) continue;
    const auto found = problem.on_plane(p + problem.depth(i, p) * half_spaces[i].normal, i);
    if (!found) return std::nullopt;
    x = *found;
  }
  return x;
}

}  // namespace shapegauge

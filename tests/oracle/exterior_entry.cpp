#include "tests/oracle/exterior_entry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/oracle/offset_tolerance.h"
#include "tests/oracle/rounded_triangle.h"

namespace shapegauge {

namespace {

/// The ray's parameter where it leaves a cube that it is in.
double exit_from_cube(const ExteriorCell& cell, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  double exit = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    if (std::abs(direction[k]) < 1e-12) continue;  // never gets to the face, which it may run in
    const double face = cell.centre[k] + (direction[k] > 0 ? cell.half : -cell.half);
    exit = std::min(exit, (face - origin[k]) / direction[k]);
  }
  return exit;
}

}  // namespace

std::optional<std::int32_t> ExteriorEntrySearch::covering(const Eigen::Vector3d& x) {
  const double r = exterior_.r();
  for (const std::int32_t triangle : recent_) {
    if (triangle < 0) break;
    if ((closest_point(exterior_.tree().triangle(triangle), x) - x).squaredNorm() < r * r) return triangle;
  }
  const auto found = exterior_.tree().any_within(x, r);
  if (found) recent_[oldest_++ % recent_.size()] = *found;
  return found;
}

ExteriorEntry ExteriorEntrySearch::find(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  const double r = exterior_.r();
  const SurfaceTree& tree = exterior_.tree();
  const double smallest_step = offset_slack * r;
  double t = r;
  bool decided = true;
  while (true) {
    const Eigen::Vector3d x = origin + t * direction;
    const auto leaf = exterior_.leaf_at(x);
    if (!leaf) return {t, decided};
    const ExteriorNode& node = exterior_.nodes()[static_cast<std::size_t>(leaf->node)];
    if (node.kind == CellKind::free && node.may_hold_exterior) return {t, decided};
    if (!node.may_hold_exterior) {
      t = std::max(t + smallest_step / 16, exit_from_cube(*leaf, origin, direction));
      continue;
    }
    if (const auto blocking = covering(x)) {
      const double exit = exit_from_rounded_triangle(tree.triangle(*blocking), r * (1 + offset_slack), x, direction);
      t += std::max(exit, smallest_step / 16);
      continue;
    }
    const auto is_exterior = exterior_.contains(x);
    decided &= is_exterior.has_value();
    if (is_exterior == true) return {t, decided};
    t += std::max(5 * smallest_step, tree.closest(x)->distance - r);
  }
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/preparation/tube_area.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/distinct_triangles.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

namespace {

constexpr double finest_cube = 1.0 / 256;  // of the diagonal

/// Integrates the volume of the tube over a cube and its octants. For the smallest cubes, uses the fraction filled by
/// the tube of a plane that is parallel to a side, at the distance of the surface.
class TubeVolume {
 public:
  TubeVolume(const TriangleBVH& tree, double r)
      : tree_(tree), r_(r), smallest_half_(std::max(r / 2, finest_cube) / 2) {}

  [[nodiscard]] double in(const Eigen::Vector3d& centre, double half, std::int32_t hint = -1) const {
    check_();
    const double radius = std::sqrt(3.0) * half;
    const auto hit = tree_.closest(centre, r_ + radius, hint);
    const double volume = 8 * half * half * half;
    if (!hit) return 0;
    if (hit->distance + radius < r_) return volume;
    if (half <= smallest_half_) {
      const double filled = std::min(hit->distance + r_, half) - std::max(hit->distance - r_, -half);
      return volume * std::max(filled, 0.0) / (2 * half);
    }
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d direction((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
      sum += in(centre + half / 2 * direction, half / 2, hit->triangle);
    }
    return sum;
  }

 private:
  const TriangleBVH& tree_;
  double r_;
  double smallest_half_;
  SparseInterruptionCheck check_;
};

/// Counts the distinct points of a cloud.
double count_positions(const Points& points) {
  const std::vector<std::int32_t> merged = welded_vertices(points);
  std::size_t count = 0;
  for (std::size_t i = 0; i < merged.size(); ++i) count += static_cast<std::size_t>(merged[i]) == i ? 1 : 0;
  return static_cast<double>(count);
}

/// Computes Dawson's integral divided by its argument, D(s) / s = integral over [0, 1] of exp(-s^2 (1 - t^2)), by
/// Simpson's rule.
double dawson_ratio(double s_squared) {
  constexpr int intervals = 256;
  double sum = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double t = static_cast<double>(i) / intervals;
    const double weight = i == 0 || i == intervals ? 1 : i % 2 != 0 ? 4 : 2;
    sum += weight * std::exp(-s_squared * (1 - t * t));
  }
  return sum / (3 * intervals);
}

/// Solves A (1 - D(s) / s) = tube, s^2 = n pi r^2 / A, for the area A. The fixed point is unique because both sides
/// increase with A.
double corrected_for_gaps(double tube, double points, double r) {
  constexpr int rounds = 50;
  double area = tube;
  for (int i = 0; i < rounds; ++i) {
    // For a cloud too sparse to form a tube the area would tend to infinity.
    area = std::min(tube / (1 - dawson_ratio(points * std::numbers::pi * r * r / area)), 2 * tube);
  }
  return area;
}

}  // namespace

double tube_area(const Shape& shape, double r) {
  require_in_bounds("the tube's radius, a fraction of the diagonal,", r, {.low = 0, .high = 1, .low_open = true});
  require_usable(shape);
  const double diagonal = bounding_box_diagonal(shape);
  if (!(diagonal > 0) || !std::isfinite(diagonal)) {
    throw InputError(fmt::format("the shape has no usable extent (the diagonal of its bounding box is {})", diagonal));
  }
  const Shape unit_shape = in_unit_frame(without_duplicates(shape), unit_frame(shape));
  const TriangleBVH tree(unit_shape);
  const Eigen::AlignedBox3d box = bounding_box(unit_shape);
  const double volume = TubeVolume(tree, r).in(box.center(), box.sizes().maxCoeff() / 2 + r);
  double area = volume / (2 * r);
  if (is_cloud(shape)) area = corrected_for_gaps(area, count_positions(unit_shape.vertices), r);
  return area * diagonal * diagonal;
}

}  // namespace shapegauge

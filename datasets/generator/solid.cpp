// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/generator/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "shapegauge/core/base/decompositions.h"
#include "shapegauge/datasets/generator/implicit_surface.h"

namespace shapegauge {

namespace {

Eigen::AlignedBox3d box_about(const Outline& outline, double margin) {
  double radius = 0;
  Eigen::AlignedBox1d heights;
  for (const Eigen::Vector2d& point : outline) {
    radius = std::max(radius, point.x());
    heights.extend(Eigen::Matrix<double, 1, 1>(point.y()));
  }
  radius += margin;
  return {Eigen::Vector3d(-radius, -radius, heights.min()[0] - margin),
          Eigen::Vector3d(radius, radius, heights.max()[0] + margin)};
}

double distance_to_outline(const Outline& outline, const Eigen::Vector2d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < outline.size(); ++i) {
    least = std::min(least, distance_to_segment(point, outline[i - 1], outline[i]));
  }
  return least;
}

/// Returns true if a horizontal ray towards greater distances from the axis crosses a closed polygon an odd number of
/// times.
bool is_within(const Outline& polygon, const Eigen::Vector2d& point) {
  bool within = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double crossing = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (crossing > point.x()) within = !within;
  }
  return within;
}

Eigen::Vector2d about_axis(const Eigen::Vector3d& point) { return {point.head<2>().norm(), point.z()}; }

}  // namespace

Solid rounded_box(const Eigen::Vector3d& centre, const Eigen::Vector3d& half_sizes, double rounding) {
  const Eigen::Vector3d core = (half_sizes.array() - rounding).max(0);
  return {[=](const Eigen::Vector3d& point) {
            const Eigen::Vector3d beyond = (point - centre).cwiseAbs() - core;
            return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0) - rounding;
          },
          {Eigen::Vector3d(centre - half_sizes), Eigen::Vector3d(centre + half_sizes)}};
}

Solid revolved(const Outline& outline, double rounding) {
  Outline closed(outline.size() + 2);
  closed.front() = {0, outline.front().y()};
  std::ranges::copy(outline, closed.begin() + 1);
  closed.back() = {0, outline.back().y()};
  return {[=](const Eigen::Vector3d& point) {
            const Eigen::Vector2d profile_point = about_axis(point);
            const double distance = distance_to_outline(closed, profile_point);
            return (is_within(closed, profile_point) ? -distance : distance) - rounding;
          },
          box_about(outline, rounding)};
}

Solid revolved_wall(const Outline& outline, double thickness) {
  return {[=](const Eigen::Vector3d& point) { return distance_to_outline(outline, about_axis(point)) - thickness / 2; },
          box_about(outline, thickness / 2)};
}

Solid rounded_cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, double rounding) {
  const double length = (to - from).norm();
  const Outline outline = {{radius - rounding, rounding}, {radius - rounding, length - rounding}};
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = rotation_between(Eigen::Vector3d::UnitZ(), to - from);
  motion.translation() = from;
  return transformed_solid(revolved(outline, rounding), motion);
}

Solid tube(const std::vector<LimbNode>& nodes, const Eigen::Vector3d& flat_axis, double flatness) {
  const Skeleton skeleton{"", {{.nodes = nodes, .flat_axis = flat_axis, .flatness = flatness}}};
  const auto surface = std::make_shared<const ImplicitSurface>(skeleton);
  // Splines leave the nodes' balls slightly; the radius allows for that.
  Eigen::AlignedBox3d box;
  for (const LimbNode& node : nodes) {
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(1.5 * node.radius);
    box.extend(Eigen::Vector3d(node.position - margin));
    box.extend(Eigen::Vector3d(node.position + margin));
  }
  return {[surface](const Eigen::Vector3d& point) { return surface->nearest_limb(point).distance; }, box};
}

Solid intersection(const Solid& solid, const Solid& within) {
  return {[=](const Eigen::Vector3d& point) { return std::max(solid.distance(point), within.distance(point)); },
          solid.box};
}

Solid difference(const Solid& solid, const Solid& removed) {
  return {[=](const Eigen::Vector3d& point) { return std::max(solid.distance(point), -removed.distance(point)); },
          solid.box};
}

Solid slab(double low, double high) {
  return {[=](const Eigen::Vector3d& point) { return std::max(low - point.z(), point.z() - high); }, {}};
}

Solid transformed_solid(const Solid& solid, const Eigen::Isometry3d& motion) {
  const Eigen::Isometry3d back = motion.inverse();
  Solid result{[=](const Eigen::Vector3d& point) { return solid.distance(back * point); }, {}};
  for (int corner = 0; corner < 8; ++corner) {
    result.box.extend(motion * solid.box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  }
  return result;
}

Solid rotated_about_z(const Solid& solid, double degrees) {
  const double radians = degrees * std::numbers::pi / 180;
  return transformed_solid(solid, Eigen::Isometry3d(Eigen::AngleAxisd(radians, Eigen::Vector3d::UnitZ())));
}

double SolidObject::distance(const Eigen::Vector3d& point) const {
  double value = std::numeric_limits<double>::infinity();
  for (const SolidPart& part : parts) {
    const double distance = part.solid.distance(point);
    value = std::isinf(value) ? distance : smooth_minimum(value, distance, blend);
  }
  return value;
}

int SolidObject::label_at(const Eigen::Vector3d& point) const {
  const auto nearest =
      std::ranges::min_element(parts, {}, [&](const SolidPart& part) { return part.solid.distance(point); });
  return nearest->label;
}

}  // namespace shapegauge

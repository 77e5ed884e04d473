// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/generator/implicit_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapegauge {

namespace {

constexpr int pieces_per_segment = 3;

// Evaluates a uniform Catmull-Rom spline from b (t = 0) to c (t = 1).
template <typename Value>
Value catmull_rom(const Value& a, const Value& b, const Value& c, const Value& d, double t) {
  const double t2 = t * t;
  const double t3 = t2 * t;
  return a * (-0.5 * t + t2 - 0.5 * t3) + b * (1 - 2.5 * t2 + 1.5 * t3) + c * (0.5 * t + 2 * t2 - 1.5 * t3) +
         d * (-0.5 * t2 + 0.5 * t3);
}

LimbNode smooth_node(const std::vector<LimbNode>& nodes, std::size_t segment, double t) {
  const LimbNode& b = nodes[segment];
  const LimbNode& c = nodes[segment + 1];
  const LimbNode& a = segment == 0 ? b : nodes[segment - 1];
  const LimbNode& d = segment + 2 == nodes.size() ? c : nodes[segment + 2];
  const double radius = catmull_rom(a.radius, b.radius, c.radius, d.radius, t);
  // The spline may overshoot between very different radii.
  const double least = std::min(b.radius, c.radius);
  const double most = std::max(b.radius, c.radius);
  return {catmull_rom(a.position, b.position, c.position, d.position, t), std::clamp(radius, 0.9 * least, 1.1 * most)};
}

struct ConeHit {
  Eigen::Vector3d from_axis = Eigen::Vector3d::Zero();  // from the closest point of the centre line to the query
  double radius = 0;                                    // of the cone there
};

// Finds the ball of the cone that minimises |q - centre| - radius: the foot point moves towards the thick end.
ConeHit closest_ball(const RoundCone& cone, const Eigen::Vector3d& q) {
  const Eigen::Vector3d from_start = q - cone.start;
  const double along = cone.direction.dot(from_start);
  const double across = std::sqrt(std::max(0.0, from_start.squaredNorm() - along * along));
  const double t = std::clamp(along - across * cone.half_angle_tangent, cone.first, cone.last);
  return {from_start - t * cone.direction, cone.radius - t * cone.taper};
}

RoundCone round_cone(const Eigen::Vector3d& start, double start_radius, const Eigen::Vector3d& end, double end_radius,
                     int segment) {
  RoundCone cone;
  const double length = (end - start).norm();
  cone.start = start;
  cone.direction = (end - start) / length;
  cone.radius = start_radius;
  cone.taper = (start_radius - end_radius) / length;
  cone.last = length;
  cone.segment = segment;
  // If one end's ball contains the other's, the cone is that ball.
  if (cone.taper >= 1) cone.last = 0;
  if (cone.taper <= -1) cone.first = length;
  if (std::abs(cone.taper) < 1) cone.half_angle_tangent = cone.taper / std::sqrt(1 - cone.taper * cone.taper);
  return cone;
}

}  // namespace

double smooth_minimum(double a, double b, double width) {
  const double overlap = std::max(width - std::abs(a - b), 0.0);
  return std::min(a, b) - overlap * overlap / (4 * width);
}

ImplicitSurface::LimbField ImplicitSurface::make_field(const Limb& limb) {
  LimbField field;
  const Eigen::Vector3d flat = limb.flat_axis.normalized();
  field.flatness = limb.flatness;
  field.blend = limb.blend * limb.nodes.front().radius;
  field.to_round = Eigen::Matrix3d::Identity() + (1 / limb.flatness - 1) * flat * flat.transpose();
  for (std::size_t segment = 0; segment + 1 < limb.nodes.size(); ++segment) {
    for (int piece = 0; piece < pieces_per_segment; ++piece) {
      const LimbNode start = smooth_node(limb.nodes, segment, static_cast<double>(piece) / pieces_per_segment);
      const LimbNode end = smooth_node(limb.nodes, segment, static_cast<double>(piece + 1) / pieces_per_segment);
      field.cones.push_back(round_cone(field.to_round * start.position, start.radius, field.to_round * end.position,
                                       end.radius, static_cast<int>(segment)));
    }
  }
  const auto end_of = [](const RoundCone& cone) { return Eigen::Vector3d(cone.start + cone.last * cone.direction); };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const RoundCone& cone : field.cones) sum += cone.start + end_of(cone);
  field.ball_centre = sum / (2.0 * static_cast<double>(field.cones.size()));
  for (const RoundCone& cone : field.cones) {
    const double end_radius = cone.radius - cone.last * cone.taper;
    field.ball_radius = std::max({field.ball_radius, (cone.start - field.ball_centre).norm() + cone.radius,
                                  (end_of(cone) - field.ball_centre).norm() + end_radius});
  }
  return field;
}

ImplicitSurface::ImplicitSurface(const Skeleton& skeleton) {
  for (const Limb& limb : skeleton.limbs) limbs_.push_back(make_field(limb));
  const std::vector<LimbNode>& root = skeleton.limbs.front().nodes;
  centre_ = root[root.size() / 2].position;
  for (const Limb& limb : skeleton.limbs) {
    for (const LimbNode& node : limb.nodes) {
      inner_points_.push_back(node.position);
      radius_ = std::max(radius_, (node.position - centre_).norm() + node.radius);
    }
  }
  radius_ *= 1.2;
}

double ImplicitSurface::lower_bound(const LimbField& field, const Eigen::Vector3d& point) {
  const double outside = (field.to_round * point - field.ball_centre).norm() - field.ball_radius;
  return outside > 0 ? outside * field.flatness : -std::numeric_limits<double>::infinity();
}

ImplicitSurface::Nearest ImplicitSurface::nearest_on_limb(int limb, const Eigen::Vector3d& point) const {
  const LimbField& field = limbs_[static_cast<std::size_t>(limb)];
  const Eigen::Vector3d q = field.to_round * point;
  double best = std::numeric_limits<double>::infinity();
  ConeHit best_hit;
  Nearest nearest;
  for (const RoundCone& cone : field.cones) {
    const ConeHit hit = closest_ball(cone, q);
    const double value = hit.from_axis.norm() - hit.radius;
    if (value < best) {
      best = value;
      best_hit = hit;
      nearest.segment = cone.segment;
    }
  }
  // The value divided by the gradient is the distance to first order.
  const double length = best_hit.from_axis.norm();
  const double slope = length > 0 ? (field.to_round * best_hit.from_axis).norm() / length : 1;
  nearest.limb = limb;
  nearest.distance = best / slope;
  nearest.depth = length / best_hit.radius;
  nearest.radius = best_hit.radius;
  nearest.thin_radius = best_hit.radius * field.flatness;
  return nearest;
}

ImplicitSurface::Nearest ImplicitSurface::nearest_limb(const Eigen::Vector3d& point) const {
  Nearest best;
  best.distance = std::numeric_limits<double>::infinity();
  for (int limb = 0; limb < limb_count(); ++limb) {
    if (lower_bound(limbs_[static_cast<std::size_t>(limb)], point) >= best.distance) continue;
    const Nearest nearest = nearest_on_limb(limb, point);
    if (nearest.distance < best.distance) best = nearest;
  }
  return best;
}

double ImplicitSurface::operator()(const Eigen::Vector3d& point) const {
  double value = std::numeric_limits<double>::infinity();
  for (int limb = 0; limb < limb_count(); ++limb) {
    const LimbField& field = limbs_[static_cast<std::size_t>(limb)];
    // Beyond the blend's width a limb does not affect the value.
    if (lower_bound(field, point) >= value + field.blend) continue;
    const double distance = nearest_on_limb(limb, point).distance;
    value = std::isinf(value) ? distance : smooth_minimum(value, distance, field.blend);
  }
  return value;
}

}  // namespace shapegauge

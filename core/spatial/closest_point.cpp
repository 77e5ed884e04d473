#include "shapegauge/core/spatial/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace shapegauge {

Eigen::Vector3d closest_point_on_segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& x) {
  const Eigen::Vector3d ab = b - a;
  const double length2 = ab.squaredNorm();
  if (!(length2 > 0)) return a;
  return a + std::clamp(ab.dot(x - a) / length2, 0.0, 1.0) * ab;
}

namespace {

double inverse_or_zero(double length2) { return length2 > 0 ? 1 / length2 : 0; }

/// Squared distance from v, relative to the edge's start, to the edge.
double squared_distance_to_edge(const Eigen::Vector3d& v, const Eigen::Vector3d& edge, double inverse) {
  return (v - std::clamp(v.dot(edge) * inverse, 0.0, 1.0) * edge).squaredNorm();
}

}  // namespace

TriangleDistance::TriangleDistance(const Triangle& triangle)
    : a_(triangle.a),
      ab_(triangle.b - triangle.a),
      ac_(triangle.c - triangle.a),
      inverse_ab_(inverse_or_zero(ab_.squaredNorm())),
      inverse_ac_(inverse_or_zero(ac_.squaredNorm())),
      inverse_bc_(inverse_or_zero((ac_ - ab_).squaredNorm())) {
  const Eigen::Vector3d cross = ab_.cross(ac_);
  const double inverse = inverse_or_zero(cross.squaredNorm());
  normal_ = cross * std::sqrt(inverse);
  // Without an area no point projects into the triangle: its coordinates are made to fail.
  dual_b_ = inverse > 0 ? Eigen::Vector3d(ac_.cross(cross) * inverse) : Eigen::Vector3d::Constant(std::nan(""));
  dual_c_ = cross.cross(ab_) * inverse;
}

double TriangleDistance::operator()(const Eigen::Vector3d& x) const {
  const Eigen::Vector3d from_a = x - a_;
  const double b = from_a.dot(dual_b_);
  const double c = from_a.dot(dual_c_);
  if (b >= 0 && c >= 0 && b + c <= 1) {
    const double height = from_a.dot(normal_);
    return height * height;
  }
  return std::min({squared_distance_to_edge(from_a, ab_, inverse_ab_),
                   squared_distance_to_edge(from_a, ac_, inverse_ac_),
                   squared_distance_to_edge(from_a - ab_, ac_ - ab_, inverse_bc_)});
}

Eigen::Vector3d closest_point(const Triangle& triangle, const Eigen::Vector3d& x) {
  const auto& [a, b, c] = triangle;
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const Eigen::Vector3d ax = x - a;
  const Eigen::Vector3d normal = ab.cross(ac);
  const double normal2 = normal.squaredNorm();
  if (normal2 > 0) {
    const double v = ax.cross(ac).dot(normal) / normal2;
    const double w = ab.cross(ax).dot(normal) / normal2;
    if (v >= 0 && w >= 0 && v + w <= 1) return a + v * ab + w * ac;
  }
  Eigen::Vector3d best = closest_point_on_segment(a, b, x);
  for (const Eigen::Vector3d& other : {closest_point_on_segment(b, c, x), closest_point_on_segment(c, a, x)}) {
    if ((other - x).squaredNorm() < (best - x).squaredNorm()) best = other;
  }
  return best;
}

}  // namespace shapegauge

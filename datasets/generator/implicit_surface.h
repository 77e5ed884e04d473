// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// Returns the smooth minimum of two distances: smaller than both where they differ by less than the width, which
/// blends surfaces.
double smooth_minimum(double a, double b, double width);

/// Round cone: the union of balls along a segment whose radius changes linearly. Coordinates are those of the limb,
/// scaled such that its cross-section is a circle.
struct RoundCone {
  Eigen::Vector3d start;       ///< start point of the segment
  Eigen::Vector3d direction;   ///< unit vector from the start to the end of the segment
  double radius = 0;           ///< radius of the ball at the start
  double taper = 0;            ///< decrease of the ball's radius per unit of length from the start
  double slide = 0;            ///< tangent of the half angle of the cone
  double first = 0, last = 0;  ///< range of the balls' centres: distances from the start
  int segment = 0;             ///< index of the limb's segment, which begins at node `segment`
};

/// Skin of a skeleton in the rest pose: the zero set of a function, negative inside, made of round cones along the
/// limbs' smoothed centre lines. The cones of a limb are united; limbs are blended by the polynomial smooth minimum
/// (Quilez, "Smooth minimum"), which rounds creases. Near the surface the function approximates the distance.
class ImplicitSurface {
 public:
  /// Result of a closest-point query: the limb, its segment, and distances from the query point.
  struct Nearest {
    int limb = 0;            ///< index of the limb
    int segment = 0;         ///< index of the segment of the limb
    double distance = 0;     ///< signed distance to the limb's surface; to first order if flattened
    double depth = 0;        ///< distance to the limb's centre line, in local radii of the limb
    double radius = 0;       ///< radius of the limb at the closest point
    double thin_radius = 0;  ///< local half thickness of the limb along its flat axis
  };

  explicit ImplicitSurface(const Skeleton& skeleton);

  /// Evaluates the implicit function at a point: approximately the signed distance, negative inside.
  double operator()(const Eigen::Vector3d& point) const;

  /// Finds the point of one limb that is closest to a point in space.
  [[nodiscard]] Nearest nearest_on_limb(int limb, const Eigen::Vector3d& point) const;

  /// Finds the limb with the minimum signed distance from a point.
  [[nodiscard]] Nearest nearest_limb(const Eigen::Vector3d& point) const;

  [[nodiscard]] int limb_count() const { return static_cast<int>(limbs_.size()); }

  /// Returns the centre of a ball of radius() that contains the surface with a margin; it lies inside the surface.
  [[nodiscard]] const Eigen::Vector3d& centre() const { return centre_; }
  [[nodiscard]] double radius() const { return radius_; }

  /// Returns the positions of the nodes of all limbs, which lie inside the surface.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& inner_points() const { return inner_points_; }

 private:
  struct LimbField {
    Eigen::Matrix3d to_round;  // scales along the flat axis, which makes the cross-section of the limb a circle
    double flatness = 1;
    double blend = 0;
    std::vector<RoundCone> cones;
    Eigen::Vector3d ball_centre;  // centre of the limb's bounding ball, in scaled coordinates
    double ball_radius = 0;
  };

  static LimbField make_field(const Limb& limb);
  [[nodiscard]] static double lower_bound(const LimbField& field, const Eigen::Vector3d& point);

  std::vector<LimbField> limbs_;
  std::vector<Eigen::Vector3d> inner_points_;
  Eigen::Vector3d centre_;
  double radius_ = 0;
};

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// Returns the smooth minimum of two distances: smaller than both where they differ by less than the width, which
/// blends surfaces.
double smooth_minimum(double a, double b, double width);

/// Round cone: the union of balls along a segment whose radius changes linearly. In the limb's coordinates, in which
/// its cross-section is a circle.
struct RoundCone {
  Eigen::Vector3d start;       ///< one end of the segment
  Eigen::Vector3d direction;   ///< unit vector to the other end
  double radius = 0;           ///< at the start
  double taper = 0;            ///< decrease of the radius per unit of length
  double slide = 0;            ///< tangent of the cone's half angle
  double first = 0, last = 0;  ///< range of lengths along the direction that contains the balls
  int segment = 0;             ///< segment of the limb, from node `segment` to the next
};

/// Skin of a skeleton in the rest pose: the zero set of a function, negative inside, made of round cones along the
/// limbs' smoothed centre lines. The cones of a limb are united; limbs are blended by the polynomial smooth minimum
/// (Quilez, "Smooth minimum"), which rounds creases. Near the surface the function approximates the distance.
class ImplicitSurface {
 public:
  /// Result of a closest-point query.
  struct Nearest {
    int limb = 0;
    int segment = 0;
    double distance = 0;     ///< signed distance to the limb, to first order if the limb is flattened
    double depth = 0;        ///< distance to the centre line, in local radii of the limb
    double radius = 0;       ///< local radius of the limb
    double thin_radius = 0;  ///< local radius across the flat side
  };

  explicit ImplicitSurface(const Skeleton& skeleton);

  /// Evaluates the function: negative inside.
  double operator()(const Eigen::Vector3d& point) const;

  /// Finds the closest point of one limb.
  [[nodiscard]] Nearest nearest_on_limb(int limb, const Eigen::Vector3d& point) const;

  /// Finds the limb with the minimum distance.
  [[nodiscard]] Nearest nearest_limb(const Eigen::Vector3d& point) const;

  [[nodiscard]] int limb_count() const { return static_cast<int>(limbs_.size()); }

  /// Centre and radius of a ball that contains the surface with a margin; the centre lies inside the surface.
  [[nodiscard]] const Eigen::Vector3d& centre() const { return centre_; }
  [[nodiscard]] double radius() const { return radius_; }

  /// Returns the nodes of all limbs: points throughout the inside.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& inner_points() const { return inner_points_; }

 private:
  struct LimbField {
    Eigen::Matrix3d to_round;  // stretches space along the flat axis; the limb's cross-section becomes a circle
    double flatness = 1;
    double blend = 0;
    std::vector<RoundCone> cones;
    Eigen::Vector3d ball_centre;  // bounding ball in the limb's own coordinates
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

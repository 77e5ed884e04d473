// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// Returns the smooth minimum of the distances a and b to two surfaces: less than both if they differ by less than
/// `width`, which blends the surfaces.
double smooth_minimum(double a, double b, double width);

/// Round cone: the union of balls along a segment whose radius changes linearly. Coordinates are those of the limb,
/// scaled such that its cross-section is a circle.
struct RoundCone {
  Eigen::Vector3d start;      ///< start point of the segment
  Eigen::Vector3d direction;  ///< unit vector from the start to the end of the segment
  double radius = 0;          ///< radius of the ball at the start
  double taper = 0;           ///< decrease of the ball's radius per unit of length from the start
  double half_angle_tangent =
      0;  ///< tangent of the angle between the cone's axis and its side; negative if it widens from the start
  double first = 0, last = 0;  ///< range of the balls' centres, as distances from the start of the segment
  int segment = 0;             ///< index of the segment in its limb; it begins at the limb's node of this index
};

/// Skin of a skeleton in the rest pose: the zero set of a function, negative inside, made of round cones along the
/// limbs' smoothed centre lines. The cones of a limb are united; limbs are blended by the polynomial smooth minimum
/// (Quilez, "Smooth minimum"), which rounds creases. Near the surface the function approximates the distance.
class ImplicitSurface {
 public:
  /// Result of a closest-point query: the limb, its segment, and distances from the query point.
  struct Nearest {
    int limb = 0;            ///< index of the limb in Skeleton::limbs
    int segment = 0;         ///< index, within the limb, of the segment nearest to the query point
    double distance = 0;     ///< signed distance to the limb's surface; to first order if flattened
    double depth = 0;        ///< distance to the limb's centre line, in radii of the limb: 1 on its surface
    double radius = 0;       ///< radius of the limb at the closest point of its centre line
    double thin_radius = 0;  ///< half thickness of the limb along Limb::flat_axis at the closest point
  };

  explicit ImplicitSurface(const Skeleton& skeleton);  ///< makes the skin of a skeleton in the rest pose

  /// Evaluates the implicit function at a point: approximately the signed distance, negative inside.
  double operator()(const Eigen::Vector3d& point) const;

  /// Finds the point of one limb that is closest to a point in space.
  [[nodiscard]] Nearest nearest_on_limb(int limb, const Eigen::Vector3d& point) const;

  /// Finds the limb with the minimum signed distance from a point.
  [[nodiscard]] Nearest nearest_limb(const Eigen::Vector3d& point) const;

  /// Returns the number of limbs of the skeleton.
  [[nodiscard]] int limb_count() const { return static_cast<int>(limbs_.size()); }

  /// Returns the centre of a ball of radius() that contains the surface with a margin; it lies inside the surface.
  [[nodiscard]] const Eigen::Vector3d& centre() const { return centre_; }
  [[nodiscard]] double radius() const { return radius_; }  ///< radius of the ball about centre()

  /// Returns the positions of the nodes of all limbs, which lie inside the surface.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& inner_points() const { return inner_points_; }

 private:
  struct LimbField {               // implicit function of one limb
    Eigen::Matrix3d to_round;      // scales along the flat axis, which makes the cross-section of the limb a circle
    double flatness = 1;           // thickness along the flat axis relative to the width (Limb::flatness)
    double blend = 0;              // width of the blend with other limbs, in coordinate units
    std::vector<RoundCone> cones;  // cones along the centre line, in scaled coordinates
    Eigen::Vector3d ball_centre;   // centre of the limb's bounding ball, in scaled coordinates
    double ball_radius = 0;        // radius of the bounding ball, in scaled coordinates
  };

  static LimbField make_field(const Limb& limb);  ///< computes the implicit function of a limb
  /// Returns a lower bound of the distance from a point to a limb; -infinity in the limb's bounding ball.
  [[nodiscard]] static double lower_bound(const LimbField& field, const Eigen::Vector3d& point);

  std::vector<LimbField> limbs_;               // implicit function of each limb
  std::vector<Eigen::Vector3d> inner_points_;  // positions of the nodes of all limbs
  Eigen::Vector3d centre_;                     // centre of a ball that contains the surface
  double radius_ = 0;                          // radius of this ball
};

}  // namespace shapegauge

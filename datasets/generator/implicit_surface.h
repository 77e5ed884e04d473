#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// The lesser of two distances, less where they differ by less than the width: surfaces blend there.
double smooth_minimum(double a, double b, double width);

/// A round cone: the union of balls along a segment, the radius going linearly from one end to the other. In the
/// coordinates of its limb, in which the limb is round.
struct RoundCone {
  Eigen::Vector3d start;       ///< one end of the segment
  Eigen::Vector3d direction;   ///< unit vector to the other end
  double radius = 0;           ///< at the start
  double taper = 0;            ///< by how much the radius falls over a unit of length
  double slide = 0;            ///< tangent of the cone's half angle
  double first = 0, last = 0;  ///< the lengths along the direction between which the balls lie
  int segment = 0;             ///< the limb's segment (from node `segment` to the next) that it belongs to
};

/// A skeleton's skin in the rest pose: the zero set of a function that is negative inside, made of round cones along
/// the limbs' smoothed centre lines. The cones of a limb are united; limbs are blended with the polynomial smooth
/// minimum (Quilez, "Smooth minimum"), which rounds the creases off. Near the surface the function is close to the
/// distance.
class ImplicitSurface {
 public:
  /// What a point is closest to.
  struct Nearest {
    int limb = 0;
    int segment = 0;
    double distance = 0;     ///< signed distance to the limb, to first order where the limb is flattened
    double depth = 0;        ///< distance to the centre line, in radii of the limb there
    double radius = 0;       ///< radius of the limb there
    double thin_radius = 0;  ///< the same, across the flat side
  };

  explicit ImplicitSurface(const Skeleton& skeleton);

  /// Value of the function: negative inside.
  double operator()(const Eigen::Vector3d& point) const;

  /// The closest point of one limb.
  [[nodiscard]] Nearest nearest_on_limb(int limb, const Eigen::Vector3d& point) const;

  /// The limb with the least distance.
  [[nodiscard]] Nearest nearest_limb(const Eigen::Vector3d& point) const;

  [[nodiscard]] int limb_count() const { return static_cast<int>(limbs_.size()); }

  /// Centre and radius of a ball that holds the surface with room to spare; the centre lies inside the surface.
  [[nodiscard]] const Eigen::Vector3d& centre() const { return centre_; }
  [[nodiscard]] double radius() const { return radius_; }

  /// The nodes of all limbs: points all over the inside.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& inner_points() const { return inner_points_; }

 private:
  struct LimbField {
    Eigen::Matrix3d to_round;  // stretches space along the flat axis, so that the limb's cross-section becomes a circle
    double flatness = 1;
    double blend = 0;
    std::vector<RoundCone> cones;
    Eigen::Vector3d ball_centre;  // a ball, in the limb's own coordinates, that holds the limb
    double ball_radius = 0;
  };

  static LimbField make_field(const Limb& limb);
  [[nodiscard]] double lower_bound(const LimbField& field, const Eigen::Vector3d& point) const;

  std::vector<LimbField> limbs_;
  std::vector<Eigen::Vector3d> inner_points_;
  Eigen::Vector3d centre_;
  double radius_ = 0;
};

}  // namespace shapegauge

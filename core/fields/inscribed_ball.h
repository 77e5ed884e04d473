// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {

/// Cache version of inscribed_ball(); see docs/manual/cache.md.
inline constexpr int inscribed_ball_version = 4;

/// Options of inscribed_ball().
struct InscribedBallOptions {
  double separation_angle_degrees = 105;  ///< minimum angle, seen from the ball's centre, between sample and contact
  bool parallel = true;                   ///< distribute the samples over the threads of the calling TBB arena
};

/// Names, bounds and help texts of the parameters in InscribedBallOptions (option_parameters.h).
inline constexpr std::array inscribed_ball_table = {
    with_unit("degrees", option_of<&InscribedBallOptions::separation_angle_degrees>(
                             "separation_angle_degrees", {.low = 0, .high = 180, .high_open = true},
                             "Minimum angle at the centre of the measuring ball between the sample and the opposite "
                             "contact; contacts at smaller angles are ignored.")),
};

/// Side of the surface on which a ball touches it: balls inside measure walls, balls outside measure gaps.
enum class BallSide {
  inside,   ///< opposite to the outward normal of the sample; the diameter is the wall thickness
  outside,  ///< in the direction of the outward normal of the sample; the diameter is the width of a gap
};

/// Ball that touches the surface at a sample and at an opposite point, in the shape's units.
struct TouchingBall {
  double diameter = 0;      ///< diameter of the ball: the thickness of a wall or the width of a gap
  Eigen::Vector3d contact;  ///< opposite point of the surface that the ball touches
  /// Angle at the ball's centre between the sample and the contact, or between the surface normals at the two,
  /// whichever is larger: 180 between parallel walls.
  double angle_degrees = 0;
};

/// Balls that touch a shape's surface at samples. Several queries on the same shape share its search tree.
class TouchingBalls {
 public:
  /// Keeps a reference to the shape. Throws InputError for an angle out of range, an unusable shape, and a cloud
  /// without normals.
  TouchingBalls(const Shape& shape, const InscribedBallOptions& options);
  ~TouchingBalls();
  TouchingBalls(TouchingBalls&&) noexcept;
  TouchingBalls& operator=(TouchingBalls&&) noexcept;
  TouchingBalls(const TouchingBalls&) = delete;
  TouchingBalls& operator=(const TouchingBalls&) = delete;

  /// Returns one diameter per sample, NaN if missing, as inscribed_ball() does, for balls on either side of the
  /// surface. Throws InputError for samples without one normal each.
  [[nodiscard]] Eigen::VectorXd diameters(const Samples& samples, BallSide side) const;

  /// Returns the ball that touches the surface at a point with a unit normal; nothing if the ball's diameter is not
  /// below `limit`. The smaller the limit, the faster. The diameter is at most 0.1 % too large.
  [[nodiscard]] std::optional<TouchingBall> ball_at(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                                    BallSide side, double limit) const;

  /// Returns false only if no ball of a diameter below `limit` touches the surface at any point of `part`, a piece of a
  /// triangle of the mesh with the unit normal `normal`; may return true if there is no such ball.
  [[nodiscard]] bool may_touch(const Triangle& part, const Eigen::Vector3d& normal, BallSide side, double limit) const;

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

/// Computes the diameter of the largest ball that touches the surface at the sample from inside and contains no
/// opposite point of the surface, in the shape's units: the wall thickness
/// (docs/reference/definitions.md#inscribed-ball).
///
/// A point is opposite if it is at least the separation angle away from the sample, seen from the centre of the ball
/// through both, and if the same holds for the angle between the outward normals. The outward side of a triangle is the
/// one facing away from the sample, whatever its orientation. At a separation angle of 0 every point is opposite. Above
/// 90 degrees the two sides of a right-angled edge are not opposite. The triangles around a sampled vertex never stop
/// the ball.
///
/// The diameter is exact unless many triangles are about equally near to the centre, as in a finely tessellated sphere;
/// then it is at most 0.1 % too large. NaN if the sample has no normal, and if nothing stops the ball before its
/// diameter reaches the bounding-box diagonal. For a cloud the points are the surface, and the cloud must have normals.
/// The same input gives the same bytes on any number of threads. Throws InputError as TouchingBalls does.
Eigen::VectorXd inscribed_ball(const Shape& shape, const Samples& samples, const InscribedBallOptions& options = {});

}  // namespace shapegauge

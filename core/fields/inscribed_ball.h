#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {

/// Raised with every change of inscribed_ball() that changes a value, which makes cached results of earlier versions
/// stale.
inline constexpr int inscribed_ball_version = 1;

/// Settings of inscribed_ball().
struct InscribedBallOptions {
  double separation_angle_degrees = 60;  ///< least angle between the outward normals of the sample and of a contact
  bool parallel = true;                  ///< spread the samples over the threads of the calling TBB arena
};

/// What may be chosen of InscribedBallOptions.
inline constexpr std::array inscribed_ball_table = {
    option_of<&InscribedBallOptions::separation_angle_degrees>(
        "separation_angle_degrees", {.low = 0, .high = 180, .high_open = true},
        "Least angle, at the ball's centre, between the sample and the contact that stops the ball."),
};

/// Radius of the largest ball that touches a plane at the origin, lies on the side of its unit normal, and does not
/// reach into a triangle: the least |q|^2 / (2 q.normal) over the triangle's points q above the plane. Nothing where
/// there is no such point, and for a triangle with a corner at the origin. A degenerate triangle is the segment or the
/// point that it is.
std::optional<double> touching_ball_radius(const Triangle& triangle, const Eigen::Vector3d& normal);

/// Diameter of the largest ball inside of the shape that touches its surface at the sample, in the shape's units: twice
/// the medial radius, and the wall's thickness where two sides are parallel.
///
/// The ball lies against the outward normal of the sample and shrinks until nothing reaches into it (the shrinking ball
/// of Ma, Bae and Choi 2012, 3D medial axis point approximation using nearest neighbors and the normal field; here with
/// the triangles themselves in place of sampled points, so that the result is exact). A triangle can stop the ball
/// where its outward normal differs from the sample's by the separation angle or more: a tessellated or noisy surface
/// bends towards the ball next to the sample, as the true one does not. At 0 every triangle can; above 90 degrees the
/// sides next to a right-angled edge cannot, and what is left is the thickness between opposite sides. At a vertex, the
/// triangles about it never stop the ball. Outward, of a triangle, is away from the sample, however it is oriented.
///
/// Sphere: the diameter. Slab: its thickness. Box: at distance d from an edge 2 d, where that is less than the
/// thickness. NaN where the sample has no normal, and where nothing stops the ball before its diameter is the bounding
/// box's diagonal. Of a cloud the points are the surface, and their normals must come with it. The same bytes on any
/// number of threads. Throws InputError for an angle out of range, an unusable shape, a cloud without normals, and
/// samples without a normal each.
Eigen::VectorXd inscribed_ball(const Shape& shape, const Samples& samples, const InscribedBallOptions& options = {});

}  // namespace shapegauge

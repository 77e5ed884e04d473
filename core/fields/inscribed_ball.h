#pragma once

#include <Eigen/Core>
#include <array>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version of inscribed_ball(); see docs/manual/cache.md.
inline constexpr int inscribed_ball_version = 1;

/// Options of inscribed_ball().
struct InscribedBallOptions {
  double separation_angle_degrees = 60;  ///< minimum angle between the outward normals of sample and contact
  bool parallel = true;                  ///< distribute the samples over the threads of the calling TBB arena
};

/// Parameters of InscribedBallOptions.
inline constexpr std::array inscribed_ball_table = {
    measured_in("degrees",
                option_of<&InscribedBallOptions::separation_angle_degrees>(
                    "separation_angle_degrees", {.low = 0, .high = 180, .high_open = true},
                    "Minimum angle at the ball's centre between the sample and the contact that stops the ball.")),
};

/// Computes the diameter of the largest ball inside the shape that touches its surface at the sample, in the shape's
/// units. It is twice the medial radius, and the wall thickness between parallel sides.
///
/// The ball lies opposite to the outward normal of the sample and shrinks until nothing intersects it. This is the
/// shrinking ball of Ma, Bae and Choi (2012, 3D medial axis point approximation using nearest neighbors and the normal
/// field), made exact by using triangles instead of sampled points. A triangle stops the ball only if its outward
/// normal differs from the sample's by at least the separation angle, because a tessellated or noisy surface bends
/// towards the ball next to the sample. At 0 every triangle can stop it. Above 90 degrees the sides next to a
/// right-angled edge cannot, which leaves the thickness between opposite sides. The triangles around a sampled vertex
/// never stop the ball. The outward side of a triangle is the one facing away from the sample, whatever its
/// orientation.
///
/// Sphere: the diameter. Slab: its thickness. Box: 2 d at distance d from an edge, where that is less than the
/// thickness. NaN if the sample has no normal, and if no triangle stops the ball before its diameter reaches the
/// bounding-box diagonal. For a cloud the points are the surface, and the cloud must have normals. The same bytes on
/// any number of threads. Throws InputError for an angle out of range, an unusable shape, a cloud without normals, and
/// samples without one normal each.
Eigen::VectorXd inscribed_ball(const Shape& shape, const Samples& samples, const InscribedBallOptions& options = {});

}  // namespace shapegauge

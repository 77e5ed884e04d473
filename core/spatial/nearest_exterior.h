#pragma once

#include <Eigen/Core>

#include "shapegauge/core/spatial/exterior_on_sphere.h"
#include "shapegauge/core/spatial/offset_exterior.h"

namespace shapegauge {

/// The point of the outer offset surface that is closest to a point p of the surface (the design, section 2.2, step 1),
/// to within 0.008 r. The normal, of length 1 or zero, says where to look first.
///
/// A descent from p + r n or p - r n gives a first local minimum: the point is projected onto the half-spaces that the
/// nearest triangles leave free, again and again. Then it is proven or improved upon: E is connected and unbounded, so
/// a part of it closer to p would have to cross the sphere about p that passes 0.008 r below the minimum. The sphere is
/// cut into patches, smaller and smaller, until each lies within r of one triangle or in enclosed space; a point of E
/// on it starts the next descent. A passage whose half-width exceeds r by less than 0.003 r may go unseen. Pass the
/// same object for neighbouring points.
ExteriorPoint nearest_exterior_point(const OffsetExterior& exterior, const Eigen::Vector3d& p,
                                     const Eigen::Vector3d& normal, SearchMemory& memory);

}  // namespace shapegauge

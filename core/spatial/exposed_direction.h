#pragma once

#include <Eigen/Core>
#include <optional>

#include "shapegauge/core/spatial/offset_exterior.h"

namespace shapegauge {

/// The middle of the directions u, up to 60 degrees from an axis, in which the ball of radius r about a point p of the
/// surface is exposed to the exterior: p + r u lies outside of the offset solid, in E(r). Nothing where none is found.
///
/// Every point of a cloud has a patch of the offset surface of its own, all of it as near to p as can be; only the
/// middle of the patch says which way the surface faces. It is looked for with 33 directions about the axis, then with
/// 33 about the middle found. What is returned is exposed itself.
std::optional<Eigen::Vector3d> middle_of_exposed(const OffsetExterior& exterior, const Eigen::Vector3d& p,
                                                 const Eigen::Vector3d& axis);

}  // namespace shapegauge

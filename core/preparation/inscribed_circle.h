#pragma once

#include <Eigen/Core>
#include <vector>

namespace shapegauge {

/// The radius of the largest circle inside a polygon in the plane (corners in order, either way round): never too
/// large, and too small by at most a hundredth of itself and a thousandth of the diagonal of the polygon's box. 0 for
/// fewer than three corners.
double inscribed_circle_radius(const std::vector<Eigen::Vector2d>& polygon);

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>
#include <vector>

namespace shapegauge {

/// The radius of the largest circle inside a polygon in the plane (corners in order, either way round), found on ever
/// finer grids about the best place so far: within a hundredth for the holes that meshes have, and never too large. 0
/// for fewer than three corners.
double inscribed_circle_radius(const std::vector<Eigen::Vector2d>& polygon);

}  // namespace shapegauge

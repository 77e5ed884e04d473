#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace shapegauge {

/// The triangles at the origin of the Delaunay triangulation of the origin and points of the plane: pairs of places in
/// `points`, counterclockwise. None across a gap of half a turn or more, as on a border.
std::vector<std::array<std::int32_t, 2>> delaunay_star(std::span<const Eigen::Vector2d> points);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace shapegauge {

/// Computes the Delaunay triangulation of the origin and points of the plane, and returns its triangles at the origin.
/// Each is given by the indices of its other two corners in `points`, counterclockwise. There is no triangle across a
/// gap of half a turn or more, as on a boundary.
std::vector<std::array<std::int32_t, 2>> delaunay_star(std::span<const Eigen::Vector2d> points);

}  // namespace shapegauge

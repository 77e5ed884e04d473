// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// Triangle in space, by the coordinates of its corners a, b, c.
struct Triangle {
  Eigen::Vector3d a, b, c;
};

/// Returns the point of a triangle closest to x, by the Voronoi regions of its face, edges and corners. Degenerate
/// triangles are handled as segments or points.
Eigen::Vector3d closest_point(const Triangle& triangle, const Eigen::Vector3d& x);

/// Returns the point of the segment ab closest to x.
Eigen::Vector3d closest_point_on_segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& x);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Triangulation of polygons of shape files; not part of the public interface.
namespace shapegauge {

/// Triangle of a polygon, as indices of the polygon's corners.
using PolygonTriangle = std::array<std::int32_t, 3>;

/// Maximum number of corners of a polygon in a shape file; readers reject larger polygons.
inline constexpr std::size_t max_polygon_corners = 100000;

/// Triangulates a polygon that is not covered by the fan of triangles about its first corner. Projects the polygon onto
/// its plane (Newell's normal) and computes the constrained Delaunay triangulation. A corner may touch other corners or
/// edges, as a bridge edge to a hole does. If a polygon has an edge that leads inside and back, there are more
/// triangles than in the fan.
///
/// Returns nothing if the fan should be kept: it covers the polygon (always if convex), or the projected polygon
/// intersects itself or has no area. The triangles have the polygon's orientation and ascending order. They do not
/// depend on the size and position of the polygon.
std::vector<PolygonTriangle> triangles_in_place_of_fan(std::span<const Eigen::Vector3d> corners);

/// Computes the constrained Delaunay triangulation of a planar polygon of positive signed area. Returns nothing if the
/// polygon intersects itself.
std::vector<PolygonTriangle> constrained_delaunay(std::span<const Eigen::Vector2d> corners);

}  // namespace shapegauge

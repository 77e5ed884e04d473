#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Polygons of shape files as triangles. Not for users of the library.
namespace shapegauge {

/// A triangle of a polygon, as positions among the polygon's corners.
using PolygonTriangle = std::array<std::int32_t, 3>;

/// Largest number of corners of a polygon that is read.
inline constexpr std::size_t most_polygon_corners = 100000;

/// Triangulates a polygon whose fan of triangles about the first corner does not cover it: the polygon is projected
/// onto its plane (Newell's normal) and its constrained Delaunay triangulation taken. A corner may touch other corners
/// or edges, as where an edge leads to a hole and back. Where an edge leads inside and back there are more triangles
/// than in the fan.
///
/// Returns nothing where the fan is kept: it covers the polygon, as it does every convex one, or the projected polygon
/// crosses itself or has no area. The triangles have the polygon's orientation, in ascending order. They do not depend
/// on the size and position of the polygon.
std::vector<PolygonTriangle> triangles_in_place_of_fan(std::span<const Eigen::Vector3d> corners);

/// Constrained Delaunay triangulation of a polygon in the plane whose signed area is positive. Empty where the
/// polygon crosses itself.
std::vector<PolygonTriangle> constrained_delaunay(std::span<const Eigen::Vector2d> corners);

}  // namespace shapegauge

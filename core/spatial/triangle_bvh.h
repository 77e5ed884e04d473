// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {

/// Result of a closest-point query on the triangles of a shape.
struct ClosestHit {
  std::int32_t triangle = -1;                                 ///< index of the closest triangle
  double distance = std::numeric_limits<double>::infinity();  ///< distance from the query point to `point`
  Eigen::Vector3d point = Eigen::Vector3d::Zero();            ///< point of the triangle closest to the query point
};

/// Ball to which a search in a TriangleBVH is restricted.
struct Ball {
  Eigen::Vector3d centre;  ///< centre of the ball, in the shape's coordinates
  double radius;           ///< radius of the ball, finite, in the shape's units
};

/// Solid cone to which a search in a TriangleBVH is restricted: all directions from an apex that differ from the unit
/// axis by at most an angle. The normals of the triangles can be restricted too.
struct Cone {
  Eigen::Vector3d apex;  ///< common origin of the directions, in the shape's coordinates
  Eigen::Vector3d axis;  ///< unit vector along the middle of the cone
  double cosine;         ///< cosine of the angle between the axis and the boundary of the cone, at most 90 degrees
  /// Cosine of the largest allowed angle between the axis and a triangle's normal, with either sign; -1: any
  /// triangles.
  double min_normal_cosine = -1;
  bool faces_away = false;  ///< true if min_normal_cosine limits only the normal that points away from the apex
};

/// Bounding volume hierarchy over the triangles of a shape for proximity queries. Nodes have eight children and leaves
/// sixteen triangles, laid out for SIMD; the instruction set is chosen at run time.
///
/// Determines the closest triangle in single precision relative to the leaf's own origin, and its distance and point in
/// double precision. The distance is therefore never too small, and too large by less than 1e-6 of the sum of itself
/// and the leaf's size. Coordinates should be of the order of 1. Queries are thread-safe.
class TriangleBVH {
 public:
  /// Builds the tree over all triangles, including degenerate ones, or over a cloud's points as degenerate triangles.
  /// Keeps no reference to the shape.
  explicit TriangleBVH(const Shape& shape);
  ~TriangleBVH();
  TriangleBVH(TriangleBVH&&) noexcept;
  TriangleBVH& operator=(TriangleBVH&&) noexcept;
  TriangleBVH(const TriangleBVH&) = delete;
  TriangleBVH& operator=(const TriangleBVH&) = delete;

  /// Returns the triangle closest to x if its distance is below max_distance. `hint`, the index of any triangle that is
  /// probably near (-1: none), speeds up the query and does not change the distance.
  [[nodiscard]] std::optional<ClosestHit> closest(const Eigen::Vector3d& x,
                                                  double max_distance = std::numeric_limits<double>::infinity(),
                                                  std::int32_t hint = -1) const;

  /// Calls `visit(triangle, ball)` at least for all triangles that intersect both ball and cone, roughly in order of
  /// their distance from the cone's apex; after each leaf of the tree it is called with the triangle -1. `visit` may
  /// replace the ball by a smaller one inside it, which prunes the search. Radii must be finite.
  void search(const Cone& cone, Ball& ball, const std::function<void(std::int32_t, Ball&)>& visit) const;

  /// Returns the corners of a triangle, by its index in the shape.
  [[nodiscard]] const Triangle& triangle(std::int32_t index) const;

 private:
  struct Layout;
  std::unique_ptr<Layout> layout_;
};

}  // namespace shapegauge

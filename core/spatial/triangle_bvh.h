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

/// What a query found: a triangle, its point closest to the query point, and the distance between the two.
struct ClosestHit {
  std::int32_t triangle = -1;
  double distance = std::numeric_limits<double>::infinity();
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

/// A ball.
struct Ball {
  Eigen::Vector3d centre;
  double radius;
};

/// Bounding volume hierarchy over the triangles of a shape for proximity queries: eight children a node, sixteen
/// triangles a leaf, both laid out for SIMD, with the instruction set chosen at run time.
///
/// Which triangle is closest is decided in single precision relative to the leaf's own origin; the distance and point
/// that are returned are those of that triangle in double precision. The distance is therefore never too small, and too
/// large by less than 1e-6 of the sum of itself and the leaf's size. Coordinates should be of the order of 1.
/// Queries are safe to call from many threads.
class TriangleBVH {
 public:
  /// Builds the tree over all triangles, degenerate ones too; over a cloud's points as triangles of no size. The shape
  /// is not kept.
  explicit TriangleBVH(const Shape& shape);
  ~TriangleBVH();
  TriangleBVH(TriangleBVH&&) noexcept;
  TriangleBVH& operator=(TriangleBVH&&) noexcept;
  TriangleBVH(const TriangleBVH&) = delete;
  TriangleBVH& operator=(const TriangleBVH&) = delete;

  /// The closest triangle among those nearer than max_distance, or nothing. A hint, any triangle that is likely to be
  /// near, makes the query faster and does not change the distance.
  [[nodiscard]] std::optional<ClosestHit> closest(const Eigen::Vector3d& x,
                                                  double max_distance = std::numeric_limits<double>::infinity(),
                                                  std::int32_t hint = -1) const;

  /// Calls `shrink(triangle, ball)` for all triangles that meet the ball, and for some that do not, roughly from near
  /// to far. `shrink` may replace the ball by one that lies inside of it: triangles that meet only the larger one are
  /// then left out. Returns the last ball. Radii are finite.
  [[nodiscard]] Ball shrunk_ball(Ball ball, const std::function<void(std::int32_t, Ball&)>& shrink) const;

  /// The corners of a triangle, in the shape's numbering.
  [[nodiscard]] const Triangle& triangle(std::int32_t index) const;

 private:
  struct Layout;
  std::unique_ptr<Layout> layout_;
};

}  // namespace shapegauge

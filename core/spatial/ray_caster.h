#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Where a ray met a shape.
struct RayHit {
  std::int32_t triangle = -1;  ///< -1: nothing was hit
  double distance = 0;         ///< from the origin, in the shape's units
  bool leaving = false;        ///< the ray runs along the triangle's normal: out of a shape that is oriented outwards

  explicit operator bool() const { return triangle >= 0; }
};

/// Rays against the triangles of a shape.
///
/// Which triangle is hit is decided in single precision, in coordinates in which the shape is centred and its diagonal
/// is 1, without gaps between triangles that share an edge; the distance is then found in double precision. Size and
/// place of the shape therefore do not matter. Where several triangles are hit at the same distance, the one that comes
/// first in the shape is reported. Safe to use from many threads at once.
class RayCaster {
 public:
  /// Builds the tree, a better one where about so many rays are worth it. The shape is not kept. Without triangles,
  /// nothing is ever hit.
  explicit RayCaster(const Shape& shape, Eigen::Index rays = 0);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// The first triangle from the origin along the unit direction, `skipped` left out (a few; they are searched one by
  /// one).
  [[nodiscard]] RayHit first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                 std::span<const std::int32_t> skipped = {}) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Intersection of a ray with a shape.
struct RayHit {
  std::int32_t triangle = -1;  ///< index of the triangle that was hit; -1 if the ray hits none
  double distance = 0;         ///< distance from the ray's origin to the hit, in the shape's units
  bool leaving = false;  ///< true if the ray crosses the triangle along its normal: it leaves an outward-oriented shape

  /// Returns true if the ray hit a triangle.
  explicit operator bool() const { return triangle >= 0; }
};

/// Handling of rays that pass through an edge or a vertex, to single precision.
enum class EdgeHandling {
  robust,  ///< the ray hits one of the adjacent triangles
  fast     ///< about one ray in a million slips between the triangles; all rays take a sixth less time
};

/// Casts rays against the triangles of a shape.
///
/// Determines the closest triangle in single precision, in coordinates in which the shape is centred and has a diagonal
/// of 1, and its distance in double precision. The result therefore does not depend on the size and position of the
/// shape. Ignores triangles closer to the ray's origin than 2^-22 diagonals, whose side rounding makes uncertain. Of
/// several triangles at the same distance, reports the first in the shape. Thread-safe.
class RayCaster {
 public:
  /// Builds the search tree of the triangles; keeps no reference to the shape. Without triangles, all rays miss.
  explicit RayCaster(const Shape& shape, EdgeHandling edge_handling = EdgeHandling::robust);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// Returns the first hit along the unit direction, ignoring the triangles with the indices `skipped` (a short list,
  /// searched linearly).
  [[nodiscard]] RayHit first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                 std::span<const std::int32_t> skipped = {}) const;

  /// Casts one ray per unit direction from a common origin, ignoring the triangles with the indices `skipped`. Writes
  /// the first hits to `hits`, which must have the size of `directions`.
  void first_hits(const Eigen::Vector3d& origin, std::span<const Eigen::Vector3d> directions,
                  std::span<const std::int32_t> skipped, std::span<RayHit> hits) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace shapegauge

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

/// What becomes of a ray that passes through an edge or a vertex, to single precision.
enum class RaysAtEdges {
  hit,      ///< it hits one of the triangles there
  may_slip  ///< it may slip between them, as about one ray in a million does; all rays take a sixth less time
};

/// Rays against the triangles of a shape.
///
/// Which triangle is hit is decided in single precision, in coordinates in which the shape is centred and its diagonal
/// is 1; the distance is then found in double precision. Size and place of the shape therefore do not matter. Triangles
/// closer to the origin than 2^-22 diagonals are not hit: rounded, it might lie on either side of them. Where several
/// triangles are hit at the same distance, the one that comes first in the shape is reported. Safe to use from many
/// threads at once.
class RayCaster {
 public:
  /// Builds the tree. The shape is not kept. Without triangles, nothing is ever hit.
  explicit RayCaster(const Shape& shape, RaysAtEdges at_edges = RaysAtEdges::hit);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// The first triangle from the origin along the unit direction, `skipped` left out (a few; they are searched one by
  /// one).
  [[nodiscard]] RayHit first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                 std::span<const std::int32_t> skipped = {}) const;

  /// The same for many rays from one origin: `hits`, as long as `directions`, receives the hit of each.
  void first_hits(const Eigen::Vector3d& origin, std::span<const Eigen::Vector3d> directions,
                  std::span<const std::int32_t> skipped, std::span<RayHit> hits) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "tests/oracle/offset_exterior.h"

namespace shapegauge {

/// Where a ray enters the exterior.
struct ExteriorEntry {
  double distance = 0;  ///< from the ray's origin
  bool decided = true;  ///< false where its belonging to the exterior could not be decided and was assumed
};

/// Finds the first point at which a ray from a point of the surface enters the exterior E(r)
/// (docs/reference/definitions.md#offset-sdf), for one ray after another. The first stretch of length r is in the
/// offset solid, as the surface is. From there the search walks from cube to cube of the octree, and in cubes that may
/// hold exterior points from the end of one rounded triangle to the next. It remembers the triangles of the rays
/// before: pass neighbouring rays one after the other. Keeps a reference to the exterior.
class ExteriorEntrySearch {
 public:
  explicit ExteriorEntrySearch(const OffsetExterior& exterior) : exterior_(exterior) { recent_.fill(-1); }

  /// The direction has length 1.
  ExteriorEntry find(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

 private:
  /// Returns a triangle within r of x, if there is one.
  [[nodiscard]] std::optional<std::int32_t> covering(const Eigen::Vector3d& x);

  const OffsetExterior& exterior_;
  std::array<std::int32_t, 4> recent_;
  std::size_t oldest_ = 0;
};

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "shapegauge/core/spatial/offset_exterior.h"

namespace shapegauge {

/// What searches for neighbouring points have in common: which triangle covered which part of the last spheres. It
/// saves queries; what is found may depend on it within the tolerance of the search.
class SearchMemory {
 public:
  static constexpr int levels = 5;

  SearchMemory() { triangles_.fill(-1); }

  /// The triangle for a patch: a face of the circumscribed cube, and the column and row of the patch among the 2^level
  /// times 2^level patches of the face; level is below levels.
  std::int32_t& covering_triangle(int face, int level, int column, int row) {
    const int side = 1 << level;
    return triangles_[static_cast<std::size_t>(face * patches_per_face + (side * side - 1) / 3 + row * side + column)];
  }

 private:
  static constexpr int patches_per_face = ((1 << (2 * levels)) - 1) / 3;
  std::array<std::int32_t, static_cast<std::size_t>(6 * patches_per_face)> triangles_;
};

/// What was found on a sphere.
struct SphereFinding {
  std::optional<Eigen::Vector3d> exterior_point;
  bool decided = true;  ///< false where there is free space on the sphere that was taken for enclosed for want of proof
};

/// Some exterior point on a sphere, or none where the sphere is proven to have none, down to patches that reach
/// smallest_radius from their centres.
SphereFinding exterior_point_on_sphere(const OffsetExterior& exterior, const Eigen::Vector3d& centre, double radius,
                                       double smallest_radius, SearchMemory& memory);

}  // namespace shapegauge

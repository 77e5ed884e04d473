#pragma once

#include <cstdint>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// To be raised with every change of refined() that changes a mesh: what a cache holds of earlier versions is then
/// computed anew.
inline constexpr int refinement_version = 1;

/// Settings of refined().
struct RefinementOptions {
  double longest_edge = 0.03;            ///< above 0, at most 10; of the square root of the surface's area
  std::int32_t most_vertices = 200'000;  ///< at least 3; refinement ends before there are more
};

/// The mesh with its long edges cut in half until none is longer: the same surface with places enough for fields that
/// live at vertices, on meshes of a few large or long triangles. A pass cuts the longest edge of every triangle that
/// has too long a one, and all triangles at that edge with it, so that no gaps open, soups and non-manifold meshes
/// included. Long thin triangles are cut across. The shape's vertices stay the first ones; clouds and meshes fine
/// enough stay as they are. Throws InputError for options out of range and an unusable shape (validity.h).
Shape refined(Shape shape, const RefinementOptions& options = {});

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/exterior_grid.h"
#include "shapegauge/core/shape/shape.h"

/// Tests whether samples lie on the surface.

namespace shapegauge {

/// Returns for each of `samples` samples the index of the triangle that is_on_surface() should test first: triangle i
/// for sample i if there is one sample per triangle (or point of a cloud), a triangle at vertex i if there is one
/// sample per vertex, otherwise triangle 0.
std::vector<std::int32_t> likely_triangles(const Shape& shape, Eigen::Index samples);

/// Returns true if p (in cells) lies on the surface, up to r / 1000. Tests `triangle`, which probably contains p, then
/// the triangles that have sampled points (GridPoints) near p. `nearby` is a scratch buffer for the points' indices.
bool is_on_surface(const ExteriorGrid& exterior, const Shape& shape, const Eigen::Vector3d& p, std::int32_t triangle,
                   std::vector<std::uint32_t>& nearby);

}  // namespace shapegauge

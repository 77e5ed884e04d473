// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/exterior_grid.h"
#include "shapegauge/core/shape/shape.h"

/// Tests whether samples lie on the surface.

namespace shapegauge {

/// Returns for each sample a triangle that probably contains it: its own if all faces are sampled, one of its vertex's
/// if all vertices are, otherwise the first.
std::vector<std::int32_t> likely_triangles(const Shape& shape, Eigen::Index samples);

/// Returns true if p (in cells) lies on the surface. Tests the triangle that probably contains p, then those of the
/// surface's points near it. `nearby` is a buffer for their indices.
bool is_on_surface(const ExteriorGrid& exterior, const Shape& shape, const Eigen::Vector3d& p, std::int32_t triangle,
                   std::vector<std::uint32_t>& nearby);

}  // namespace shapegauge

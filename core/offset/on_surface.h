// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/exterior_grid.h"
#include "shapegauge/core/shape/shape.h"

/// Tests whether samples lie on the surface.

namespace shapegauge {

/// Returns for each sample the index of a triangle that probably contains it: the face itself if there is one sample
/// per face, a face of the vertex if there is one sample per vertex, otherwise the first face. `samples` is their
/// number.
std::vector<std::int32_t> likely_triangles(const Shape& shape, Eigen::Index samples);

/// Returns true if p (in cells) lies on the surface. Tests `triangle`, which probably contains p, then the triangles of
/// the surface points near p. `nearby` is a scratch buffer for the indices of these points.
bool is_on_surface(const ExteriorGrid& exterior, const Shape& shape, const Eigen::Vector3d& p, std::int32_t triangle,
                   std::vector<std::uint32_t>& nearby);

}  // namespace shapegauge

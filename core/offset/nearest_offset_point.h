#pragma once

#include <Eigen/Core>
#include <optional>

#include "shapegauge/core/offset/exterior_grid.h"

namespace shapegauge {

/// Computes the point of E(r) nearest to p in the neighbourhood of a site, in cells: iterates projections of p onto the
/// half-spaces tangent to the balls about the triangles nearest to the current point, starting with `triangle` at the
/// site. Returns nothing if the iteration fails or approaches a known result.
std::optional<Eigen::Vector3d> nearest_offset_point(const ExteriorGrid& exterior, const Eigen::Vector3d& p,
                                                    const Eigen::Vector3d& site, std::int32_t triangle,
                                                    const std::optional<Eigen::Vector3d>& known);

}  // namespace shapegauge

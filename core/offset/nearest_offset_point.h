#pragma once

#include <Eigen/Core>
#include <optional>

#include "shapegauge/core/offset/exterior_grid.h"

namespace shapegauge {

/// The point of E(r) nearest to p about a site near it (in cells), or nothing where the site is of no use: p is
/// projected onto the half-spaces that the triangles nearest to the result leave free, again and again. Nothing, too,
/// where it leads to one that is known already.
std::optional<Eigen::Vector3d> nearest_offset_point(const ExteriorGrid& exterior, const Eigen::Vector3d& p,
                                                    const Eigen::Vector3d& site, std::int32_t triangle,
                                                    const std::optional<Eigen::Vector3d>& known);

}  // namespace shapegauge

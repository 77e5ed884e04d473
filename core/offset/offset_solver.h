// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Outcome of a sample.
enum class OffsetOutcome : std::uint8_t {
  direct,     ///< q is p + r n or p - r n
  searched,   ///< q was found by iteration
  undecided,  ///< no iteration converged: q is a point of the offset surface near the nearest one
  missing,    ///< not a point of the surface
};

/// Options of solve_on_grid().
struct OffsetSolverOptions {
  double offset = 0.05;         ///< r
  double cells_per_offset = 3;  ///< r / h: 2.5 to 16
  bool parallel = true;         ///< use the threads of the calling TBB arena
};

/// Results per sample, in the shape's units.
struct OffsetResults {
  Eigen::VectorXd values;   ///< |qq'| - 2r; NaN where missing
  Points directions;        ///< (q - p)/|q - p|; zero where missing
  Eigen::VectorXd heights;  ///< |pq|; NaN where missing
  std::vector<OffsetOutcome> outcomes;
  double offset = 0;         ///< r as used: larger than requested if the grid would exceed the memory bound
  double build_seconds = 0;  ///< time for points, flood fill and sites
};

/// Computes the SDF of the offset surface (docs/methods/offset_sdf.md) on a grid, at points of a shape with unit or
/// zero normals.
///
/// The diagonal of the shape's bounding box must be about 1. Cells have the edge r / cells_per_offset. Memory is
/// bounded: an offset that needs more than 2^24 blocks or about 6 million points on the surface is raised until it
/// fits. Pass the triangles that contain the points, if known, to skip the lookup.
OffsetResults solve_on_grid(const Shape& shape, const Points& points, const Points& normals,
                            const OffsetSolverOptions& options, const std::vector<std::int32_t>& triangles = {});

}  // namespace shapegauge

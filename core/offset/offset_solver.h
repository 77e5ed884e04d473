// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: p sample, n its normal, r offset distance, h edge of a cell, q closest exterior point, q' opposite exit.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Outcome of the search for q, the exterior point closest to a sample p with normal n.
enum class OffsetOutcome : std::uint8_t {
  direct,     ///< the closest exterior point q is p + r n or p - r n (n the normal at the sample p)
  searched,   ///< the closest exterior point q was found by iteration
  undecided,  ///< no iteration converged: q is the nearest site, a point of the offset surface up to two cells too far
  missing,    ///< no value: p does not lie on the surface
};

/// Options of solve_on_grid().
struct OffsetSolverOptions {
  double offset = 0.05;         ///< offset distance r, in the shape's units
  double cells_per_offset = 3;  ///< offset distance r in cells of the grid, 2.5 to 16
  bool parallel = true;         ///< use the threads of the calling TBB arena
};

/// Results of solve_on_grid(), in the shape's units, one entry per sample p. q is the exterior point closest to p, and
/// q' the point where the ray from q through p enters the exterior again.
struct OffsetResults {
  Eigen::VectorXd values;   ///< SDF per sample, in the shape's units; NaN where missing
  Points directions;        ///< unit vector from each sample to its closest exterior point; zero where missing
  Eigen::VectorXd heights;  ///< distance from each sample to its closest exterior point; NaN where missing
  std::vector<OffsetOutcome> outcomes;  ///< outcome of each sample: how its closest exterior point was found
  double offset = 0;         ///< offset distance used: larger than requested if the grid would exceed the memory bound
  double build_seconds = 0;  ///< time for surface points, flood fill and sites, in seconds
};

/// Computes the SDF of the offset surface (docs/methods/offset_sdf.md) on a grid, at points of a shape with unit or
/// zero normals.
///
/// The diagonal of the shape's bounding box must be about 1. Cells have the edge r / cells_per_offset. Memory is
/// bounded: an offset that needs more than 2^24 blocks or about 6 million points on the surface is raised until it
/// fits. `triangles` has the index of the triangle that contains each point, if known, and is empty otherwise.
OffsetResults solve_on_grid(const Shape& shape, const Points& points, const Points& normals,
                            const OffsetSolverOptions& options, const std::vector<std::int32_t>& triangles = {});

}  // namespace shapegauge

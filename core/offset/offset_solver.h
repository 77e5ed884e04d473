#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// How a sample was answered.
enum class OffsetOutcome : std::uint8_t {
  direct,     ///< q = p + r n or p - r n
  searched,   ///< q found by search
  undecided,  ///< the search came to no end: q is a point of the offset surface near the nearest one
  missing,    ///< not a point of the surface
};

/// What is asked of the grid.
struct OffsetGridOptions {
  double offset = 0.05;         ///< r
  double cells_per_offset = 3;  ///< r / h: 2.5 to 16
  bool parallel = true;         ///< spread the work over the threads of the calling TBB arena
};

/// Answers, sample by sample, in the shape's unit.
struct OffsetAnswers {
  Eigen::VectorXd values;   ///< |qq'| - 2r; NaN where missing
  Points directions;        ///< (q - p)/|q - p|; zero where missing
  Eigen::VectorXd heights;  ///< |pq|; NaN where missing
  std::vector<OffsetOutcome> outcomes;
  double offset = 0;         ///< r as used: more than was asked where the grid would not fit into memory
  double build_seconds = 0;  ///< points, flood and sites
};

/// The SDF of the offset surface (docs/methods/offset_sdf.md) at points of a shape with normals of length 1 or 0, by a
/// grid.
///
/// The shape's bounding box must have a diagonal of about 1. The grid's cells measure r / cells_per_offset. Memory is
/// bounded: of an offset so small that there would be more than 2^24 blocks or 6 million points on the surface, the
/// least one for which there are not is taken. Who knows on which triangles the points lie saves looking for them.
OffsetAnswers answer_by_grid(const Shape& shape, const Points& points, const Points& normals,
                             const OffsetGridOptions& options, const std::vector<std::int32_t>& triangles = {});

}  // namespace shapegauge

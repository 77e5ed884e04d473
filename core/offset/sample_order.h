// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "shapegauge/core/offset/block_grid.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Samples sorted by block, so that those computed together are near each other. Samples outside the grid are left out.
struct SampleOrder {
  SampleOrder(const BlockGrid& grid, const Points& points, const Points& normals);

  struct Range {
    std::size_t begin, end;
  };
  std::vector<Eigen::Index> samples;  ///< indices of the samples
  std::vector<Range> groups;          ///< samples of each block
  std::vector<Range> batches;         ///< of groups: consecutive ones, whose samples share the lanes of vectors
};

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "shapegauge/core/offset/block_grid.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Order in which samples are computed: sorted by block, so that consecutive samples are near each other. Samples
/// outside the grid, or not finite, are omitted.
struct SampleOrder {
  SampleOrder(const BlockGrid& grid, const Points& points, const Points& normals);

  /// Range of indices from begin to before end.
  struct Range {
    std::size_t begin, end;
  };
  std::vector<Eigen::Index> samples;  ///< indices of the samples, sorted by block
  std::vector<Range> groups;          ///< per block with samples: range in `samples`
  std::vector<Range> batches;         ///< per batch, whose samples share the lanes of vectors: range in `groups`
};

}  // namespace shapegauge

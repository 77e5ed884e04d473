// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "shapegauge/core/offset/block_grid.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Order in which samples are computed: sorted by block of the grid, so that consecutive samples are near each other.
/// Samples outside the grid, or with a position or normal that is not finite, are omitted.
struct SampleOrder {
  SampleOrder(const BlockGrid& grid, const Points& points, const Points& normals);

  /// Range of indices from begin to before end.
  struct Range {
    std::size_t begin, end;  ///< first index, and one after the last
  };
  std::vector<Eigen::Index> samples;  ///< indices of the samples, sorted by block
  std::vector<Range> groups;          ///< per block that contains samples: range of indices in `samples`
  std::vector<Range> batches;         ///< per batch of samples that are computed together: range of indices in `groups`
};

}  // namespace shapegauge

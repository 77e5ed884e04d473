// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "shapegauge/core/offset/mean_normals.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// Where the samples of a shape with a diagonal of 1 are raised to, for an offset of r, with the means that the grid
/// with cells of r/3 has.
class RaisedSamples {
 public:
  RaisedSamples(const Shape& shape, double r)
      : grid_(bounding_box(shape), r, r / 3),
        surface_(grid_, shape, 0.75, false),
        means_(grid_, shape, surface_, false) {}

  /// On either side of p; the distance is d, exactly.
  template <typename Distance>
  [[nodiscard]] std::array<Eigen::Vector3d, 2> of(const Eigen::Vector3d& p, const Eigen::Vector3d& normal,
                                                  const Distance& distance) const {
    const double r = grid_.r * grid_.cell;
    const Eigen::Vector3d mean = means_.at(grid_.to_cells(p), normal);
    const auto on_side = [&](double side) {
      const double depth = std::max(0.0, 1 - distance(p + side * r * normal) / r);
      return raised(p, side * normal, side * mean, depth, r);
    };
    return {on_side(1), on_side(-1)};
  }

 private:
  BlockGrid grid_;
  GridSurface surface_;
  MeanNormals means_;
};

}  // namespace shapegauge::test

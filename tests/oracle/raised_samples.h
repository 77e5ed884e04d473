// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "shapegauge/core/offset/mean_normals.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// Raised sample points of the offset SDF, for a shape with a diagonal of 1 and an offset of r: moved off the surface
/// along the sample's normal and the mean normal (mean_normals.h), which a grid with cells of r/3 provides.
class RaisedSamples {
 public:
  RaisedSamples(const Shape& shape, double r)
      : grid_(bounding_box(shape), r, r / 3),
        surface_(grid_, shape, 0.75, false),
        means_(grid_, shape, surface_, false) {}

  /// Returns the raised points of the sample at p on either side of the surface: first along `normal`, then against it.
  /// distance(x) must return the exact distance from x to the surface.
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

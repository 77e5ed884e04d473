#pragma once

#include <Eigen/Core>

#include "shapegauge/core/offset/mean_normals.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// By what samples of a shape with a diagonal of 1 are raised, for an offset of r, as the grid with cells of r/3 has
/// it.
class Lifts {
 public:
  Lifts(const Shape& shape, double r)
      : grid_(bounding_box(shape), r, r / 3), surface_(grid_, shape, 0.75, false), means_(grid_, shape, surface_) {}

  [[nodiscard]] Eigen::Vector3d of(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) const {
    return raised_by * grid_.r * grid_.cell * means_.at(grid_.to_cells(p), normal);
  }

 private:
  BlockGrid grid_;
  GridSurface surface_;
  MeanNormals means_;
};

}  // namespace shapegauge::test

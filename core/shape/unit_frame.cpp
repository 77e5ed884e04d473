#include "shapegauge/core/shape/unit_frame.h"

namespace shapegauge {

UnitFrame unit_frame(const Shape& shape) {
  const Eigen::AlignedBox3d box = bounding_box(shape);
  if (box.isEmpty()) return {};
  // Halves, so that the largest coordinates do not overflow.
  const Eigen::Vector3d centre = box.min() / 2 + box.max() / 2;
  const double diagonal = box.sizes().stableNorm();
  return {centre, diagonal > 0 ? diagonal : 1};
}

Shape in_unit_frame(const Shape& shape, const UnitFrame& frame) {
  Shape result{shape.vertices, shape.triangles};
  for (Eigen::Index i = 0; i < result.vertices.rows(); ++i) {
    result.vertices.row(i) = frame.to_unit(shape.vertices.row(i).transpose()).transpose();
  }
  return result;
}

}  // namespace shapegauge

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

}  // namespace shapegauge

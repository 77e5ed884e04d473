#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The coordinates in which a shape lies about the origin with a diagonal of 1, so that single precision and fixed
/// thresholds serve whatever the shape's place and size.
struct UnitFrame {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double diagonal = 1;

  [[nodiscard]] Eigen::Vector3d to_unit(const Eigen::Vector3d& x) const { return (x - centre) / diagonal; }
};

/// The frame of a shape's bounding box; one of size 1 where the box has no extent.
UnitFrame unit_frame(const Shape& shape);

/// The shape in the frame's coordinates, without normals.
Shape in_unit_frame(const Shape& shape, const UnitFrame& frame);

}  // namespace shapegauge

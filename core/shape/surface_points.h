#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/random/random_numbers.h"

namespace shapegauge {

/// Points on a mesh, and the triangle on which each lies.
struct SurfacePoints {
  Points points;
  std::vector<std::int32_t> triangles;
};

/// So many points of a mesh, uniform by area. The area is cut, triangle after triangle, into as many equal parts as
/// there are to be points, and each part has one point: that spreads them better than independent ones. Throws
/// InputError for a mesh whose area is zero or not finite, and for less than one point.
SurfacePoints surface_points(const Shape& mesh, Eigen::Index count, RandomNumbers& random);

}  // namespace shapegauge

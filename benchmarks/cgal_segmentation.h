#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The parts of a mesh by CGAL: its SDF, a Gaussian mixture of so many clusters, an alpha-expansion with the weight
/// `smoothing`, connected components. The max-flow is Debian's libmaxflow. Throws InputError where CGAL cannot hold the
/// mesh.
std::vector<std::int32_t> cgal_segmentation(const Shape& shape, int clusters, double smoothing);

}  // namespace shapegauge

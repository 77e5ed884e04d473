// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Segments a mesh with CGAL and returns one label per triangle: CGAL's shape diameter function, a Gaussian mixture of
/// `clusters` components, an alpha-expansion with the weight `smoothing`, connected components. The max-flow is
/// Debian's libmaxflow. Throws InputError if CGAL cannot represent the mesh.
std::vector<std::int32_t> cgal_segmentation(const Shape& shape, int clusters, double smoothing);

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/random/random_numbers.h"

namespace shapegauge {

/// The number of a shape's elements: of the triangles of a mesh, of the points of a cloud.
Eigen::Index element_count(const Shape& shape);

/// Exactly round(fraction * count) of the elements, every set of that size as likely as any other (selection sampling:
/// Knuth, The Art of Computer Programming, 3.4.2, algorithm S). Throws InputError unless the fraction is in [0, 1].
std::vector<bool> random_selection(Eigen::Index count, double fraction, RandomNumbers& random);

/// The shape without the elements that are marked; the others keep their order. The vertices of a mesh all stay. Throws
/// InputError where nothing would be left.
Shape without_elements(Shape shape, const std::vector<bool>& removed);

}  // namespace shapegauge

#include "shapegauge/core/perturbation/flip_orientation.h"

#include <utility>

#include "shapegauge/core/perturbation/shape_elements.h"

namespace shapegauge {

Shape flip_orientation(Shape shape, double fraction, RandomNumbers& random) {
  const std::vector<bool> flipped = random_selection(element_count(shape), fraction, random);
  for (std::size_t i = 0; i < flipped.size(); ++i) {
    if (!flipped[i]) continue;
    const auto element = static_cast<Eigen::Index>(i);
    if (!is_cloud(shape)) {
      std::swap(shape.triangles(element, 1), shape.triangles(element, 2));
    } else if (shape.normals.rows() > 0) {
      shape.normals.row(element) *= -1;
    }
  }
  return shape;
}

}  // namespace shapegauge

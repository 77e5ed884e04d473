#include "shapegauge/core/perturbation/remove_faces.h"

#include <utility>

#include "shapegauge/core/perturbation/shape_elements.h"

namespace shapegauge {

Shape remove_faces(Shape shape, double fraction, RandomNumbers& random) {
  const std::vector<bool> removed = random_selection(element_count(shape), fraction, random);
  return without_elements(std::move(shape), removed);
}

}  // namespace shapegauge

#include "shapegauge/core/perturbation/required_extent.h"

#include <cmath>
#include <fmt/format.h>

#include "shapegauge/core/error.h"

namespace shapegauge {

double required_diagonal(const Shape& shape) {
  const double diagonal = bounding_box_diagonal(shape);
  if (!std::isnormal(diagonal)) {
    throw InputError(fmt::format(
        "the shape cannot be changed in proportion to its size: the diagonal of its bounding box is {}", diagonal));
  }
  return diagonal;
}

}  // namespace shapegauge

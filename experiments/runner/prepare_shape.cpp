#include "shapegauge/experiments/runner/prepare_shape.h"

#include <utility>

#include "shapegauge/core/shape/normalise.h"

namespace shapegauge {

PreparedShape prepare_shape(Shape shape) {
  const double diagonal = bounding_box_diagonal(shape);
  PreparedShape prepared{.shape = scaled_to_unit_area(std::move(shape))};
  prepared.scale = bounding_box_diagonal(prepared.shape) / diagonal;
  return prepared;
}

}  // namespace shapegauge

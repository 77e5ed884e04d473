#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// A shape in the form in which fields are computed on it.
struct PreparedShape {
  Shape shape;       ///< scaled to unit area
  double scale = 1;  ///< what the file's lengths were multiplied by
};

/// Prepares a shape as it comes from its file and its perturbations. Throws InputError where it is unusable.
PreparedShape prepare_shape(Shape shape);

}  // namespace shapegauge

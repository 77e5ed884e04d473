// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Counts of the connected components of a closed, consistently oriented mesh, and its volume.
struct ClosedComponents {
  std::size_t cavities = 0;  ///< inner surfaces of a hollow body: with the opposite orientation to the largest
                             ///< component, inside the box of a larger component that is oriented like the largest
  std::size_t reversed = 0;  ///< other components with the opposite orientation to the largest one
  double volume = 0;  ///< volume of the bodies minus their cavities, in the shape's units cubed; for any orientation
};

/// Counts the components of a mesh and computes its volume; all zero for a cloud, and for a mesh that is not closed and
/// consistently oriented. Throws InputError for an unusable shape (require_usable()).
ClosedComponents closed_components(const Shape& shape);

}  // namespace shapegauge

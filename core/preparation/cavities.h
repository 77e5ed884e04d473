// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cavities, reversed components and volume of a closed, consistently oriented mesh. A component is larger if it
/// encloses more volume.
struct ClosedComponents {
  /// Number of components that are inner surfaces of hollow bodies: oriented opposite to the largest component and
  /// inside the bounding box of a larger component oriented like the largest one.
  std::size_t cavities = 0;
  std::size_t reversed = 0;  ///< number of components oriented opposite to the largest one that are not cavities
  /// Volume of the bodies minus their cavities, in the shape's units cubed; positive for any orientation.
  double volume = 0;
};

/// Counts the cavities and reversed components of a mesh and computes its volume; all zero for a cloud, and for a mesh
/// that is not closed and consistently oriented. Throws InputError for an unusable shape (require_usable()).
ClosedComponents closed_components(const Shape& shape);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/sdf/automatic_offset.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/preparation/gap_size.h"

namespace shapegauge {

AutomaticOffset automatic_offset(const ShapeDiagnostics& shape) {
  constexpr double least = 0.01;
  const double diagonal = shape.diagonal;
  if (!(diagonal > 0) || !std::isfinite(diagonal)) {
    throw InputError(fmt::format("the shape has no usable extent (the diagonal of its bounding box is {})", diagonal));
  }
  AutomaticOffset result;
  result.gap = offset_per_gap * shape.closable_gap / diagonal;
  result.widest_gap = shape.gap_size / diagonal;
  if (shape.noisy) result.noise = 2 * shape.noise_deviation / diagonal;
  const double needed = std::max({least, result.gap, result.noise});
  result.offset = std::min(needed, largest_automatic_offset);
  result.sufficient = needed <= largest_automatic_offset;
  return result;
}

AutomaticOffset automatic_offset(const Shape& shape) { return automatic_offset(diagnose(shape)); }

}  // namespace shapegauge

#include "shapegauge/core/sdf/automatic_offset.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/preparation/denoise.h"
#include "shapegauge/core/preparation/gap_size.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

AutomaticOffset automatic_offset(const Shape& shape, const AutomaticOffsetOptions& options) {
  if (!(options.least > 0 && options.least <= options.most)) {
    throw InputError(fmt::format("the automatic offset must lie between two positive bounds, not {} and {}",
                                 options.least, options.most));
  }
  require_usable(shape);
  const double diagonal = bounding_box_diagonal(shape);
  if (!(diagonal > 0) || !std::isfinite(diagonal)) {
    throw InputError(fmt::format("the shape has no usable extent (the diagonal of its bounding box is {})", diagonal));
  }
  constexpr double spare = 1.1;
  const VertexNeighbours neighbours = vertex_neighbours(shape);
  const NoiseLevel noise = noise_level(shape, neighbours);
  AutomaticOffset result;
  const GapSizes gaps = gap_sizes(shape, options.most / spare * diagonal);
  result.gap = spare * gaps.within_limit / diagonal;
  result.widest_gap = gaps.widest / diagonal;
  if (is_noisy(noise, neighbours)) result.noise = 2 * noise.deviation / diagonal;
  const double needed = std::max({options.least, result.gap, result.noise});
  result.offset = std::min(needed, options.most);
  result.sufficient = needed <= options.most;
  return result;
}

}  // namespace shapegauge

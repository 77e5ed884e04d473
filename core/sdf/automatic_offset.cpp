#include "shapegauge/core/sdf/automatic_offset.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/preparation/denoise.h"
#include "shapegauge/core/preparation/gap_size.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

constexpr double spare = 1.1;

/// Returns the diagonal of a shape that has an automatic offset.
double checked_diagonal(const Shape& shape, const AutomaticOffsetOptions& options) {
  if (!(options.least > 0 && options.least <= options.most)) {
    throw InputError(fmt::format("the automatic offset must lie between two positive bounds, not {} and {}",
                                 options.least, options.most));
  }
  require_usable(shape);
  const double diagonal = bounding_box_diagonal(shape);
  if (!(diagonal > 0) || !std::isfinite(diagonal)) {
    throw InputError(fmt::format("the shape has no usable extent (the diagonal of its bounding box is {})", diagonal));
  }
  return diagonal;
}

/// Chooses the offset for gaps in the shape's units, and for a standard deviation of noise as a fraction of the
/// diagonal.
AutomaticOffset chosen(const GapSizes& gaps, double diagonal, double noise, const AutomaticOffsetOptions& options) {
  AutomaticOffset result;
  result.gap = spare * gaps.within_limit / diagonal;
  result.widest_gap = gaps.widest / diagonal;
  result.noise = 2 * noise;
  const double needed = std::max({options.least, result.gap, result.noise});
  result.offset = std::min(needed, options.most);
  result.sufficient = needed <= options.most;
  return result;
}

}  // namespace

AutomaticOffset automatic_offset(const Shape& shape, const AutomaticOffsetOptions& options) {
  const double diagonal = checked_diagonal(shape, options);
  const Welding welding = welding_of(shape);
  const VertexNeighbours neighbours = vertex_neighbours(shape, welding);
  const NoiseLevel noise = noise_level(shape, neighbours, welding);
  return chosen(gap_sizes(shape, options.most / spare * diagonal), diagonal,
                is_noisy(noise, neighbours) ? noise.deviation / diagonal : 0, options);
}

AutomaticOffset automatic_offset(const Shape& shape, const ShapeDiagnostics& known,
                                 const AutomaticOffsetOptions& options) {
  const double diagonal = checked_diagonal(shape, options);
  const bool has_gaps = is_cloud(shape) || known.boundary_edges > 0;
  return chosen(has_gaps ? gap_sizes(shape, options.most / spare * diagonal) : GapSizes{}, diagonal,
                known.noisy ? known.noise_deviation / known.diagonal : 0, options);
}

}  // namespace shapegauge

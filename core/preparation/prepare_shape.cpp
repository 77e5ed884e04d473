#include "shapegauge/core/preparation/prepare_shape.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/error.h"
#include "shapegauge/core/preparation/denoise.h"
#include "shapegauge/core/preparation/tube_area.h"
#include "shapegauge/core/shape/normalise.h"
#include "shapegauge/core/shape/validity.h"

namespace shapegauge {

namespace {

Shape scaled_to_unit_tube_area(Shape shape) {
  const double area = tube_area(shape);
  if (!std::isnormal(area)) {
    throw InputError(fmt::format("the shape cannot be scaled to a unit tube area: its tube area is {}", area));
  }
  shape.vertices /= std::sqrt(area);
  return shape;
}

}  // namespace

PreparedShape prepare_shape(Shape shape, const PreparationOptions& options) {
  require_usable(shape);
  PreparedShape result;
  if (options.denoise) {
    DenoisedShape clean = denoised(std::move(shape));
    shape = std::move(clean.shape);
    result.noise = clean.noise;
    result.pass_band = clean.pass_band;
  }
  result.shape = options.scale == ScaleEstimate::area ? scaled_to_unit_area(std::move(shape))
                                                      : scaled_to_unit_tube_area(std::move(shape));
  return result;
}

}  // namespace shapegauge

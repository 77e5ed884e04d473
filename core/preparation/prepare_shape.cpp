#include "shapegauge/core/preparation/prepare_shape.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/error.h"
#include "shapegauge/core/preparation/denoise.h"
#include "shapegauge/core/preparation/tube_area.h"
#include "shapegauge/core/shape/normalise.h"

namespace shapegauge {

namespace {

double positive_tube_area(const Shape& shape) {
  const double area = tube_area(shape);
  if (std::isnormal(area)) return area;
  throw InputError(fmt::format("the shape cannot be scaled to a unit tube area: its tube area is {}", area));
}

}  // namespace

PreparedShape prepare_shape(Shape shape, const PreparationOptions& options) {
  PreparedShape result;
  if (options.denoise) {
    DenoisedShape clean = denoised(std::move(shape));
    shape = std::move(clean.shape);
    result.noise = clean.noise;
    result.pass_band = clean.pass_band;
  }
  result.area = options.scale == ScaleEstimate::area ? positive_area(shape) : positive_tube_area(shape);
  shape.vertices /= std::sqrt(result.area);
  result.shape = std::move(shape);
  return result;
}

}  // namespace shapegauge

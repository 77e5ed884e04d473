// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/preparation/prepare_shape.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/preparation/outliers.h"
#include "shapegauge/core/preparation/stray_normals.h"
#include "shapegauge/core/preparation/tube_area.h"
#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

double positive_area(const Shape& shape) {
  require_usable(shape);
  const double area = is_cloud(shape) ? point_weights(shape.vertices).sum() : surface_area(shape);
  // An area that is zero, subnormal or infinite would produce zeros, infinities or NaN.
  if (!(area > 0) || !std::isnormal(area)) {
    throw InputError(
        is_cloud(shape)
            ? fmt::format("the point cloud cannot be scaled to unit area: the estimated area of its {} points is {}; "
                          "it needs distinct points",
                          shape.vertices.rows(), area)
            : fmt::format("the shape cannot be scaled to unit area: the area of its {} triangles is {}; it needs a "
                          "triangle of positive, finite area",
                          shape.triangles.rows(), area));
  }
  return area;
}

namespace {

double positive_tube_area(const Shape& shape) {
  const double area = tube_area(shape);
  if (std::isnormal(area)) return area;
  throw InputError(
      fmt::format("the shape cannot be scaled to a unit tube area: its tube area is {}; use the scale \"area\"", area));
}

}  // namespace

PreparedShape prepare_shape(Shape shape, const PreparationOptions& options) {
  PreparedShape result;
  if (options.remove_outliers) shape = without_outliers(std::move(shape));
  remove_stray_normals(shape);
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

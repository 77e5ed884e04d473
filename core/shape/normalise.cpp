#include "shapegauge/core/shape/normalise.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/error.h"
#include "shapegauge/core/shape/point_weights.h"
#include "shapegauge/core/shape/validity.h"

namespace shapegauge {

double positive_area(const Shape& shape) {
  require_usable(shape);
  const double area = is_cloud(shape) ? point_weights(shape.vertices).sum() : surface_area(shape);
  // An area that is not a normal number would turn the coordinates into zeros, infinities or NaN.
  if (!(area > 0) || !std::isnormal(area)) {
    throw InputError(
        is_cloud(shape)
            ? fmt::format("the point cloud cannot be scaled to unit area: the estimated area of its {} points is {}; "
                          "it needs points at different places",
                          shape.vertices.rows(), area)
            : fmt::format("the shape cannot be scaled to unit area: the area of its {} triangles is {}; it needs a "
                          "triangle of positive, finite area",
                          shape.triangles.rows(), area));
  }
  return area;
}

Shape scaled_to_unit_area(Shape shape) {
  shape.vertices /= std::sqrt(positive_area(shape));
  return shape;
}

}  // namespace shapegauge

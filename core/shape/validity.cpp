#include "shapegauge/core/shape/validity.h"

#include <fmt/format.h>

#include "shapegauge/core/error.h"

namespace shapegauge {

std::optional<std::string> defect_of(const Shape& shape) {
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    if (!shape.vertices.row(i).allFinite()) {
      return fmt::format("vertex {} has a coordinate that is not a finite number", i);
    }
  }
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const auto triangle = shape.triangles.row(f);
    if (triangle.minCoeff() < 0 || triangle.maxCoeff() >= shape.vertices.rows()) {
      return fmt::format("triangle {} has a vertex outside 0..{}", f, shape.vertices.rows() - 1);
    }
  }
  return std::nullopt;
}

void require_usable(const Shape& shape) {
  if (const auto defect = defect_of(shape)) throw InputError(fmt::format("the shape is unusable: {}", *defect));
}

}  // namespace shapegauge

#include "shapegauge/experiments/shape_comparison/measured_shape.h"

#include <utility>

namespace shapegauge {

ReferenceShape make_reference(std::string key, Shape shape) {
  ReferenceShape reference{
      .key = std::move(key), .shape = {}, .diagonal = bounding_box_diagonal(shape), .normals = {}, .values = {}};
  if (!is_cloud(shape)) reference.normals.emplace(shape);
  reference.shape = std::move(shape);
  return reference;
}

}  // namespace shapegauge

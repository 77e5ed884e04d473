#include "shapegauge/core/perturbation/vertex_cloud.h"

#include <vector>

namespace shapegauge {

Shape vertex_cloud(const Shape& shape) {
  if (is_cloud(shape)) return {.vertices = shape.vertices, .triangles = {}};
  std::vector<bool> used(static_cast<std::size_t>(shape.vertices.rows()), false);
  for (const std::int32_t vertex : shape.triangles.reshaped()) used[static_cast<std::size_t>(vertex)] = true;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    if (used[static_cast<std::size_t>(i)]) kept.push_back(i);
  }
  return {.vertices = shape.vertices(kept, Eigen::all), .triangles = {}};
}

}  // namespace shapegauge

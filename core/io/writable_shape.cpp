#include "shapegauge/core/io/writable_shape.h"

#include <fmt/format.h>

#include "shapegauge/core/error.h"

namespace shapegauge {

void require_writable(const std::filesystem::path& path, const Shape& shape) {
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    if (!shape.vertices.row(i).allFinite()) {
      throw InputError(
          fmt::format("cannot write {}: vertex {} has a coordinate that is not a finite number", path.string(), i));
    }
  }
  if (has_cloud_normals(shape) && shape.normals.rows() != shape.vertices.rows()) {
    throw InputError(fmt::format("cannot write {}: {} normals for {} points", path.string(), shape.normals.rows(),
                                 shape.vertices.rows()));
  }
  if (has_cloud_normals(shape) && !shape.normals.allFinite()) {
    throw InputError(fmt::format("cannot write {}: a normal is not finite", path.string()));
  }
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const auto triangle = shape.triangles.row(f);
    if (triangle.minCoeff() < 0 || triangle.maxCoeff() >= shape.vertices.rows()) {
      throw InputError(fmt::format("cannot write {}: triangle {} has a vertex outside 0..{}", path.string(), f,
                                   shape.vertices.rows() - 1));
    }
  }
}

}  // namespace shapegauge

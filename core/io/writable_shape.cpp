#include "shapegauge/core/io/writable_shape.h"

#include <fmt/format.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/shape/validity.h"

namespace shapegauge {

void require_writable(const std::filesystem::path& path, const Shape& shape) {
  if (const auto defect = defect_of(shape))
    throw InputError(fmt::format("cannot write {}: {}", path.string(), *defect));
  if (has_cloud_normals(shape) && shape.normals.rows() != shape.vertices.rows()) {
    throw InputError(fmt::format("cannot write {}: {} normals for {} points", path.string(), shape.normals.rows(),
                                 shape.vertices.rows()));
  }
  if (has_cloud_normals(shape) && !shape.normals.allFinite()) {
    throw InputError(fmt::format("cannot write {}: a normal is not finite", path.string()));
  }
}

}  // namespace shapegauge

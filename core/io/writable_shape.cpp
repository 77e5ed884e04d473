#include "shapegauge/core/io/writable_shape.h"

#include <fmt/format.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/shape/validity.h"

namespace shapegauge {

void require_writable(const std::filesystem::path& path, const Shape& shape) {
  if (const auto defect = defect_of(shape))
    throw InputError(fmt::format("cannot write {}: {}", path.string(), *defect));
}

}  // namespace shapegauge

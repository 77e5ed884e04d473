#include "shapegauge/core/sdf/offset_normals.h"

#include <utility>

namespace shapegauge {

OffsetNormals offset_normals(const Shape& shape, const Samples& samples, const OffsetSdfOptions& options) {
  OffsetSdfResult result = offset_sdf(shape, samples, options);
  return {.normals = std::move(result.normals), .outcomes = result.outcomes};
}

}  // namespace shapegauge

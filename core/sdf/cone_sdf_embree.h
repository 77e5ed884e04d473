#pragma once

#include "shapegauge/core/sdf/cone_sdf.h"

namespace shapegauge {

/// The embree engine of cone_sdf(), which has checked the options and the samples.
ConeSdfResult cone_sdf_embree(const Shape& shape, const Samples& samples, const ConeSdfOptions& options);

}  // namespace shapegauge

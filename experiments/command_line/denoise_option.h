#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// What the option --denoise does: the shape without its noise (denoised()), with a line on standard error that says
/// what was found.
Shape denoised_with_report(Shape shape);

}  // namespace shapegauge

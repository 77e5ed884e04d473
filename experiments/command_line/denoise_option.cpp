#include "shapegauge/experiments/command_line/denoise_option.h"

#include <cstdio>
#include <fmt/format.h>
#include <utility>

#include "shapegauge/core/preparation/denoise.h"

namespace shapegauge {

Shape denoised_with_report(Shape shape) {
  DenoisedShape result = denoised(std::move(shape));
  if (result.pass_band > 0) {
    fmt::print(stderr, "shapegauge: noise of {:.2f} edge lengths, smoothed with a pass band of {:.3f}\n",
               result.noise.relative(), result.pass_band);
  } else {
    fmt::print(stderr, "shapegauge: no noise beyond doubt, the shape stays as it is\n");
  }
  return std::move(result.shape);
}

}  // namespace shapegauge

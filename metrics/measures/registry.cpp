#include "shapegauge/metrics/measures/registry.h"

#include <array>

#include "shapegauge/metrics/measures/average_precision.h"
#include "shapegauge/metrics/measures/discounted_cumulative_gain.h"
#include "shapegauge/metrics/measures/e_measure.h"
#include "shapegauge/metrics/measures/nearest_neighbour.h"
#include "shapegauge/metrics/measures/tier.h"

namespace shapegauge {

std::span<const Measure> measures() {
  static constexpr std::array registered = {
      Measure{"NN", nearest_neighbour},
      Measure{"FT", first_tier},
      Measure{"ST", second_tier},
      Measure{"E", e_measure},
      Measure{"DCG", discounted_cumulative_gain},
      Measure{"mAP", average_precision},
  };
  return registered;
}

}  // namespace shapegauge

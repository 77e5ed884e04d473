#include "shapegauge/core/base/number_text.h"

#include <cmath>
#include <fmt/format.h>

namespace shapegauge {

std::string two_digits(double number) {
  const bool is_short = std::abs(number) < 99.5 || std::abs(number) >= 1e6;
  return is_short ? fmt::format("{:.2g}", number) : fmt::format("{:.0f}", number);
}

}  // namespace shapegauge

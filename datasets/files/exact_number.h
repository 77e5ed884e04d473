// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

/// Converts a number of a file to double. Throws InputError for an integer of magnitude above 2^53, which double may
/// round.
template <typename Number>
double exact_number(Number number) {
  if constexpr (std::is_integral_v<Number> && sizeof(Number) == sizeof(std::int64_t)) {
    constexpr Number largest = Number{1} << 53;
    bool beyond = number > largest;
    if constexpr (std::is_signed_v<Number>) beyond = beyond || number < -largest;
    if (beyond) {
      throw InputError("the integer " + std::to_string(number) +
                       " is beyond 2^53, where numbers are rounded; scale the numbers, or save them as float64");
    }
  }
  return static_cast<double>(number);
}

}  // namespace shapegauge

#pragma once

#include <array>
#include <cstdint>

namespace shapegauge {

/// 8-bit sRGB.
using Colour = std::array<std::uint8_t, 3>;

/// Colour for a value t in [0, 1] (clamped) on a perceptually uniform map (viridis); a neutral grey where t is NaN.
Colour colour_of(double t);

}  // namespace shapegauge

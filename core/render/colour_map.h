#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace shapegauge {

/// 8-bit sRGB.
using Colour = std::array<std::uint8_t, 3>;

/// Colour for a value t in [0, 1] (clamped) on a perceptually uniform map (viridis); a neutral grey where t is NaN.
Colour colour_of(double t);

/// Colours of values on the map whose ends are `lowest` and `highest`. Where these are equal, values below, at and
/// above them have the colours of 0, 1/2 and 1.
std::vector<Colour> colours_of(const Eigen::VectorXd& values, double lowest, double highest);

}  // namespace shapegauge

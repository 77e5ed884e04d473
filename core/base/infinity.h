#pragma once

#include <limits>

namespace shapegauge {

/// Distance where there is no path, radius where nothing is touched, limit where there is none.
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace shapegauge

#pragma once

#include <optional>
#include <string_view>

namespace shapegauge {

/// The number that the whole word spells ("1", "+.5", "-2e-3", "inf", "nan"), in any locale; nothing for anything else,
/// and for a number too large or too small for double precision.
std::optional<double> parse_number(std::string_view word);

}  // namespace shapegauge

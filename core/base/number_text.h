#pragma once

#include <string>

namespace shapegauge {

/// Formats a number for messages with two significant digits, and from 100 to 10^6 as an integer: "0.12", "250".
std::string two_digits(double number);

}  // namespace shapegauge

#pragma once

#include <string>

namespace shapegauge {

/// The text with the capitals of ASCII made small; all other bytes stay.
std::string lower_case(std::string text);

}  // namespace shapegauge

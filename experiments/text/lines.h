#pragma once

#include <string_view>
#include <vector>

namespace shapegauge {

/// The lines of a text without their ends (LF or CR LF) and without a byte order mark; line i of the file is entry
/// i - 1. The views point into the text. A line end at the very end of the text begins no further line.
std::vector<std::string_view> split_lines(std::string_view text);

/// The text without blanks (space, tab) at both ends.
std::string_view without_outer_blanks(std::string_view text);

/// The text without a UTF-8 byte order mark in front.
std::string_view without_byte_order_mark(std::string_view text);

}  // namespace shapegauge

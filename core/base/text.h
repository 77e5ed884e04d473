#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// The lines of a text without their ends (LF or CR LF) and without a byte order mark; line i of the file is entry
/// i - 1. The views point into the text. A line end at the very end of the text begins no further line.
std::vector<std::string_view> split_lines(std::string_view text);

/// Whether the character is an ASCII digit, in any locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The text without leading and trailing blanks (space, tab).
std::string_view trim(std::string_view text);

/// The text without a UTF-8 byte order mark in front.
std::string_view without_byte_order_mark(std::string_view text);

/// The text with ASCII capitals in lower case; all other bytes stay.
std::string lower_case(std::string text);

/// The number that the whole word spells ("1", "+.5", "-2e-3", "inf", "nan"), in any locale; nothing for anything else,
/// and for a number too large or too small for double precision.
std::optional<double> parse_number(std::string_view word);

/// A word of a file, for a one-line message: in quotation marks, printable(), cut after 40 bytes.
std::string quoted_word(std::string_view word);

}  // namespace shapegauge

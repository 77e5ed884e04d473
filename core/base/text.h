// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Splits a text into lines without their ends (LF, CR LF, or CR in a text without LF) and byte order mark. Line i of
/// the file is entry i - 1. A trailing line end starts no further line. The views point into the text.
std::vector<std::string_view> split_lines(std::string_view text);

/// Returns true for a decimal digit, 0 to 9, in any locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Removes leading and trailing blanks (space, tab).
std::string_view trim(std::string_view text);

/// Removes a leading UTF-8 byte order mark.
std::string_view without_byte_order_mark(std::string_view text);

/// Converts ASCII capitals to lower case; leaves other bytes unchanged.
std::string lower_case(std::string text);

/// Parses a whole word as a number ("1", "+.5", "-2e-3", "inf", "nan"), in any locale. Returns nothing for other text
/// and for numbers outside the range of double precision.
std::optional<double> parse_number(std::string_view word);

/// Formats a count with a noun in the singular (`one`) or plural (`several`): "1 row", "3 rows".
std::string count_text(std::int64_t count, std::string_view one, std::string_view several);

/// Formats a number for messages with two significant digits, or as an integer if its magnitude is from 100 to 10^6:
/// "0.12", "250".
std::string two_digits(double number);

/// Formats a number with at most `digits` significant digits and without an exponent: "1234600", "0.00012". Magnitudes
/// of at least 1e15 or below 1e-9 have an exponent.
std::string plain_number(double number, int digits);

/// Quotes a word for a one-line message: in quotation marks, sanitised by printable(), truncated to 40 bytes.
std::string quoted_word(std::string_view word);

}  // namespace shapegauge

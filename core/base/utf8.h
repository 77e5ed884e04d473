#pragma once

#include <cstdint>
#include <string>

namespace shapegauge {

/// Appends a Unicode character as UTF-8.
void append_utf8(std::string& text, std::uint32_t character);

/// Converts a text that begins with the byte order mark of UTF-16, as Excel writes it, to UTF-8; returns any other text
/// as it is. Invalid surrogates become U+FFFD.
std::string to_utf8(std::string text);

}  // namespace shapegauge

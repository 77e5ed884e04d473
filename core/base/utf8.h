// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace shapegauge {

/// Appends the Unicode code point `character`, encoded as UTF-8, to `text`.
void append_utf8(std::string& text, std::uint32_t character);

/// Converts a text that begins with the byte order mark of UTF-16, as Excel writes it, to UTF-8; returns any other text
/// unchanged. Invalid surrogates become U+FFFD.
std::string to_utf8(std::string text);

/// Returns the length, in bytes, of the UTF-8 character at the beginning of the text; 0 if it is invalid.
std::size_t length_of_character(std::string_view text);

/// Replaces every byte that is not part of a UTF-8 character by its escape sequence, such as "\xE4".
std::string with_escaped_bytes(std::string_view text);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/error.h"

#include <algorithm>

#include "shapegauge/core/base/utf8.h"

namespace shapegauge {

namespace {

/// Returns true for a UTF-8 control character: C0, delete, or C1.
bool is_control(std::string_view character) {
  const auto lead = static_cast<unsigned char>(character[0]);
  return lead < 0x20 || lead == 0x7F || (lead == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0);
}

/// Returns true for a UTF-8 character that changes the direction of text: U+061C, U+200E to U+200F, U+202A to U+202E
/// and U+2066 to U+2069.
// NOLINTBEGIN(misc-misleading-bidirectional): the characters are escaped
bool changes_direction(std::string_view character) {
  const auto is_from_to = [&](std::string_view first, std::string_view last) {
    return character.size() == first.size() && character >= first && character <= last;
  };
  return character == "\u061C" || is_from_to("\u200E", "\u200F") || is_from_to("\u202A", "\u202E") ||
         is_from_to("\u2066", "\u2069");
}
// NOLINTEND(misc-misleading-bidirectional)

}  // namespace

std::string printable(std::string_view text, std::size_t longest) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(1, length));
    if (shown.size() + character.size() > longest) return shown + "...";
    shown += length == 0 || is_control(character) || changes_direction(character) ? "?" : character;
    text.remove_prefix(character.size());
  }
  return shown;
}

}  // namespace shapegauge

#include "shapegauge/core/base/error.h"

#include <algorithm>

namespace shapegauge {

namespace {

/// Returns the length of the UTF-8 character at the beginning of the text; 0 for an invalid one.
std::size_t length_of_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned lead = byte(0);
  if ((lead >= 0x80 && lead < 0xC2) || lead >= 0xF5) return 0;
  const std::size_t length = 1U + (lead >= 0xC2 ? 1U : 0U) + (lead >= 0xE0 ? 1U : 0U) + (lead >= 0xF0 ? 1U : 0U);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  }
  // Overlong encodings, surrogates, and values beyond U+10FFFF.
  const bool wrong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) > 0x9F) ||
                     (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) > 0x8F);
  return wrong ? 0 : length;
}

/// Returns true for a UTF-8 control character: C0, delete, or C1.
bool is_control(std::string_view character) {
  const auto lead = static_cast<unsigned char>(character[0]);
  return lead < 0x20 || lead == 0x7F || (lead == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0);
}

/// Returns true for a UTF-8 character that changes the direction of text: U+061C, U+200E to U+200F, U+202A to U+202E
/// and U+2066 to U+2069.
bool changes_direction(std::string_view character) {
  const auto is_from_to = [&](std::string_view first, std::string_view last) {
    return character.size() == first.size() && character >= first && character <= last;
  };
  return character == "\u061C" || is_from_to("\u200E", "\u200F") || is_from_to("\u202A", "\u202E") ||
         is_from_to("\u2066", "\u2069");
}

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

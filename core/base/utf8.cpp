// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/utf8.h"

#include <fmt/format.h>

namespace shapegauge {

void append_utf8(std::string& text, std::uint32_t character) {
  const auto append = [&](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (character < 0x80) return append(character);
  if (character < 0x800) {
    append(0xC0U | (character >> 6U));
  } else {
    if (character < 0x10000) {
      append(0xE0U | (character >> 12U));
    } else {
      append(0xF0U | (character >> 18U));
      append(0x80U | ((character >> 12U) & 0x3FU));
    }
    append(0x80U | ((character >> 6U) & 0x3FU));
  }
  append(0x80U | (character & 0x3FU));
}

std::string to_utf8(std::string text) {
  const bool little = text.starts_with("\xFF\xFE");
  if (!little && !text.starts_with("\xFE\xFF")) return text;
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    const auto byte = [&](std::size_t at) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[at])); };
    return little ? byte(i) | byte(i + 1) << 8U : byte(i) << 8U | byte(i + 1);
  };
  std::string converted;
  for (std::size_t i = 2; i + 1 < text.size(); i += 2) {
    const std::uint32_t first = unit(i);
    const bool leads = first >= 0xD800 && first < 0xDC00 && i + 3 < text.size();
    const std::uint32_t second = leads ? unit(i + 2) : 0;
    if (second >= 0xDC00 && second < 0xE000) {
      append_utf8(converted, 0x10000 + ((first - 0xD800) << 10U) + (second - 0xDC00));
      i += 2;
    } else {
      append_utf8(converted, first >= 0xD800 && first < 0xE000 ? 0xFFFD : first);
    }
  }
  return converted;
}

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

std::string with_escaped_bytes(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    if (length > 0) {
      escaped += text.substr(0, length);
    } else {
      escaped += fmt::format("\\x{:02X}", static_cast<unsigned char>(text.front()));
    }
    text.remove_prefix(length > 0 ? length : 1);
  }
  return escaped;
}

}  // namespace shapegauge

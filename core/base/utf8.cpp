#include "shapegauge/core/base/utf8.h"

#include <cstddef>

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

}  // namespace shapegauge

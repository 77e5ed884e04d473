#include "shapegauge/experiments/text/quoted_word.h"

#include <algorithm>

namespace shapegauge {

std::string quoted_word(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string shown(word.substr(0, longest));
  std::ranges::replace_if(
      shown, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return '"' + shown + (word.size() > longest ? "...\"" : "\"");
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// What a page's HTML holds.
namespace shapegauge::test {

inline std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

/// Data for the scripts.
inline nlohmann::ordered_json data_in(const std::string& page) {
  const std::string opening = R"(id="page-data">)";
  const std::size_t begin = page.find(opening) + opening.size();
  return nlohmann::ordered_json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

}  // namespace shapegauge::test

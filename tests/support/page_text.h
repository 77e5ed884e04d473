// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// Contents of HTML pages.
namespace shapegauge::test {

/// Returns the number of occurrences of a word in a text; overlapping ones count.
inline std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

/// Parses the JSON data that an HTML page contains for its scripts (the element page-data).
inline nlohmann::ordered_json json_of_page(const std::string& page) {
  const std::string opening = R"(id="page-data">)";
  const std::size_t begin = page.find(opening) + opening.size();
  return nlohmann::ordered_json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

}  // namespace shapegauge::test

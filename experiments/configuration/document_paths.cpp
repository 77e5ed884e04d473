// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/document_paths.h"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace shapegauge {

namespace {

using Json = nlohmann::json;
using Place = Json::json_pointer;

/// Removes and returns the first key of a pattern.
std::string take_key(std::string_view& pattern) {
  pattern.remove_prefix(1);  // the slash
  const std::string_view key = pattern.substr(0, pattern.find('/'));
  pattern.remove_prefix(key.size());
  return std::string(key);
}

/// Returns the positions of the children of a value that a key of a pattern matches.
std::vector<Place> matching_children(const Json& value, const Place& place, const std::string& key) {
  std::vector<Place> children;
  if (key == "*") {
    for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) children.push_back(place / i);
  } else if (value.is_object() && value.contains(key)) {
    children.push_back(place / key);
  }
  return children;
}

}  // namespace

std::vector<Place> matching_pointers(const Json& document, const std::vector<std::string>& patterns) {
  std::vector<Place> all;
  for (const std::string& pattern : patterns) {
    std::vector<Place> places{Place()};
    std::string_view keys = pattern;
    while (!keys.empty()) {
      const std::string key = take_key(keys);
      std::vector<Place> deeper;
      for (const Place& place : places) {
        for (Place& child : matching_children(document.at(place), place, key)) deeper.push_back(std::move(child));
      }
      places = std::move(deeper);
    }
    all.insert(all.end(), places.begin(), places.end());
  }
  return all;
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/document_paths.h"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace shapegauge {

namespace {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

/// Removes and returns the first key of a pattern.
std::string take_key(std::string_view& pattern) {
  pattern.remove_prefix(1);  // the slash
  const std::string_view key = pattern.substr(0, pattern.find('/'));
  pattern.remove_prefix(key.size());
  return std::string(key);
}

/// Returns the positions of the children of a value that a key of a pattern matches.
std::vector<Pointer> matching_children(const Json& value, const Pointer& pointer, const std::string& key) {
  std::vector<Pointer> children;
  if (key == "*") {
    for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) children.push_back(pointer / i);
  } else if (value.is_object() && value.contains(key)) {
    children.push_back(pointer / key);
  }
  return children;
}

}  // namespace

std::vector<Pointer> matching_pointers(const Json& document, const std::vector<std::string>& patterns) {
  std::vector<Pointer> all;
  for (const std::string& pattern : patterns) {
    std::vector<Pointer> pointers{Pointer()};
    std::string_view keys = pattern;
    while (!keys.empty()) {
      const std::string key = take_key(keys);
      std::vector<Pointer> deeper;
      for (const Pointer& pointer : pointers) {
        for (Pointer& child : matching_children(document.at(pointer), pointer, key)) deeper.push_back(std::move(child));
      }
      pointers = std::move(deeper);
    }
    all.insert(all.end(), pointers.begin(), pointers.end());
  }
  return all;
}

}  // namespace shapegauge

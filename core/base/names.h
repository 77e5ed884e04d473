#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// Pairs an enumeration value with its name in files and options.
template <typename Value>
struct Named {
  Value value;
  std::string_view name;
};

/// Returns the name of a value. The table must contain the value.
template <typename Value>
std::string name_in(std::span<const Named<Value>> table, Value value) {
  return std::string(std::ranges::find(table, value, &Named<Value>::value)->name);
}

/// Returns the value of that name, if any.
template <typename Value>
std::optional<Value> value_in(std::span<const Named<Value>> table, std::string_view name) {
  const auto found = std::ranges::find(table, name, &Named<Value>::name);
  if (found == table.end()) return std::nullopt;
  return found->value;
}

/// Returns all names, for configurations and error messages.
template <typename Value>
std::vector<std::string> names_in(std::span<const Named<Value>> table) {
  std::vector<std::string> names;
  names.reserve(table.size());
  for (const Named<Value>& named : table) names.emplace_back(named.name);
  return names;
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/model_ids.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <unordered_map>

#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/shape_file.h"

namespace shapegauge {

namespace {

// Removes a run of digits from the front of the text and returns it without leading zeros; its length then orders by
// size.
std::string_view take_number(std::string_view& text) {
  const auto end = static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
  std::string_view number = text.substr(0, end);
  text.remove_prefix(end);
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

// Compares two texts with numbers by value: T1 and T01 are equal.
std::strong_ordering compare_by_value(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view number_a = take_number(a);
      const std::string_view number_b = take_number(b);
      if (const auto order = number_a.size() <=> number_b.size(); std::is_neq(order)) return order;
      if (const auto order = number_a <=> number_b; std::is_neq(order)) return order;
      continue;
    }
    const auto order = static_cast<unsigned char>(a.front()) <=> static_cast<unsigned char>(b.front());
    if (std::is_neq(order)) return order;
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  return a.size() <=> b.size();
}

// Returns the last `count` components of a path, or all of it.
std::string end_of(const std::filesystem::path& path, std::ptrdiff_t count) {
  const std::vector<std::filesystem::path> parts(path.begin(), path.end());
  std::filesystem::path end;
  for (auto part = parts.end() - std::min(count, std::ssize(parts)); part != parts.end(); ++part) end /= *part;
  return end.string();
}

bool is_whole_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
  const auto order = compare_by_value(a, b);
  return order == std::strong_ordering::equal ? a < b : order == std::strong_ordering::less;
}

std::string canonical_model_id(std::string_view id) {
  id = without_shape_extension(id);
  if (id.starts_with('T') && is_whole_number(id.substr(1))) id.remove_prefix(1);
  return std::string(id);
}

ModelKeys::ModelKeys(const std::vector<std::string>& known_ids) {
  std::unordered_map<std::string_view, std::string_view> first_with_name;
  for (const std::string& id : known_ids) {
    const std::string_view name = without_shape_extension(id);
    if (name.size() == id.size()) continue;
    const auto first = first_with_name.emplace(name, id).first;
    if (first->second != id) ambiguous_.insert(canonical_model_id(id));
  }
}

std::string ModelKeys::of(std::string_view id) const {
  std::string canonical = canonical_model_id(id);
  return ambiguous_.contains(canonical) ? std::string(id) : canonical;
}

std::vector<std::string> distinguishing_suffixes(const std::vector<std::filesystem::path>& paths) {
  const std::size_t different = std::set(paths.begin(), paths.end()).size();
  std::ptrdiff_t longest = 1;
  for (const std::filesystem::path& path : paths) longest = std::max(longest, std::distance(path.begin(), path.end()));
  std::vector<std::string> ends;
  for (std::ptrdiff_t count = 1; count <= longest; ++count) {
    for (const bool with_extension : {false, true}) {
      ends.clear();
      for (std::filesystem::path path : paths) {
        ends.push_back(end_of(with_extension ? path : path.replace_extension(), count));
      }
      if (std::set(ends.begin(), ends.end()).size() == different) return ends;
    }
  }
  return ends;
}

}  // namespace shapegauge

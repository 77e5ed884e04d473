// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/length.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"

namespace shapegauge {

namespace {

constexpr auto length_units = std::to_array<std::pair<std::string_view, double>>(
    {{"um", 1e-6}, {"mm", 1e-3}, {"cm", 1e-2}, {"m", 1}, {"km", 1e3}, {"in", 0.0254}, {"ft", 0.3048}});

using LengthUnit = std::pair<std::string_view, double>;

}  // namespace

std::vector<std::string> length_unit_names() {
  std::vector<std::string> names;
  for (const LengthUnit& unit : length_units) names.emplace_back(unit.first);
  return names;
}

double metres_of(std::string_view unit) {
  const auto* const found = std::ranges::find(length_units, unit, &LengthUnit::first);
  if (found != length_units.end()) return found->second;
  throw InputError(
      fmt::format("unknown unit of length \"{}\"; known are {}", unit, fmt::join(length_unit_names(), ", ")));
}

std::optional<Length> parse_length(std::string_view text) {
  const std::size_t last_digit = text.find_last_of("0123456789.");
  if (last_digit == std::string_view::npos) return std::nullopt;
  const std::optional<double> value = parse_number(std::string(text.substr(0, last_digit + 1)));
  if (!value) return std::nullopt;
  std::string_view unit = text.substr(last_digit + 1);
  while (unit.starts_with(' ')) unit.remove_prefix(1);
  const bool known = unit.empty() || std::ranges::find(length_units, unit, &LengthUnit::first) != length_units.end();
  return known ? std::optional(Length{.value = *value, .unit = std::string(unit)}) : std::nullopt;
}

double in_file_units(std::string_view what, const Length& length, std::string_view file_unit) {
  if (length.unit.empty()) return length.value;
  if (file_unit.empty()) {
    throw InputError(fmt::format(
        "{} is in {}, but the unit of the files is not known (STL and OBJ have none): add `unit`", what, length.unit));
  }
  return length.value * metres_of(length.unit) / metres_of(file_unit);
}

}  // namespace shapegauge

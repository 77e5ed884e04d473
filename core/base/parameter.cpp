// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <system_error>
#include <type_traits>

#include "shapegauge/core/base/nearest_word.h"
#include "shapegauge/core/base/text.h"

namespace shapegauge {

namespace {

[[noreturn]] void fail_value(const Parameter& parameter, std::string_view value, std::string_view legal) {
  throw InputError(fmt::format("{} is {}; it must be {}", parameter.name, value, legal));
}

std::string shown(const ParameterValue& value) {
  return std::visit(
      [](const auto& v) -> std::string {
        using Value = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<Value, std::monostate>) return "of another kind";
        if constexpr (std::is_same_v<Value, std::string_view>) return quoted_word(v);
        if constexpr (std::is_arithmetic_v<Value>) return fmt::format("{}", v);
        if constexpr (std::is_same_v<Value, IntegerList>) return fmt::format("[{}]", fmt::join(v.values(), ", "));
      },
      value);
}

/// "a whole number from 1 to 9", "a finite number, in degrees".
std::string bounded(std::string_view kind, const Parameter& parameter) {
  const auto& [low, high, low_open, high_open] = parameter.bounds;
  const std::string numbers = std::isinf(low) && std::isinf(high)
                                  ? fmt::format("a finite {}", kind)
                                  : fmt::format("a {} {}", kind, to_string(parameter.bounds));
  return numbers + unit_phrase(parameter);
}

/// Parses integers separated by commas, at most as many as a list takes; nothing for other text.
std::optional<std::vector<std::int64_t>> whole_numbers(std::string_view text) {
  std::vector<std::int64_t> numbers;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); numbers.size() < IntegerList::most; ++at) {
    const auto [after, error] = std::from_chars(at, end, numbers.emplace_back());
    if (error != std::errc()) return std::nullopt;
    if (after == end) return numbers;
    if (*after != ',') return std::nullopt;
    at = after;
  }
  return std::nullopt;
}

std::optional<ParameterValue> choice_equal_to(const Parameter& parameter, const ParameterValue& value) {
  const auto* const word = std::get_if<std::string_view>(&value);
  if (word == nullptr) return std::nullopt;
  return choice_of(parameter, *word);
}

std::optional<ParameterValue> number_equal_to(const Parameter& parameter, const ParameterValue& value) {
  const auto* const whole = std::get_if<std::int64_t>(&value);
  const auto* const real = std::get_if<double>(&value);
  if (whole == nullptr && real == nullptr) return std::nullopt;
  const double number = whole != nullptr ? static_cast<double>(*whole) : *real;
  if (!parameter.bounds.contains(number)) return std::nullopt;
  return number;
}

std::optional<ParameterValue> integers_equal_to(const Parameter& parameter, const ParameterValue& value) {
  if (const auto* const one = std::get_if<std::int64_t>(&value)) {
    return integers_equal_to(parameter, IntegerList{*one});
  }
  const auto* const list = std::get_if<IntegerList>(&value);
  if (list == nullptr) return std::nullopt;
  if (list->empty()) return choice_equal_to(parameter, std::string_view("auto"));
  const auto legal = [&](std::int64_t number) { return parameter.bounds.contains(static_cast<double>(number)); };
  return std::ranges::all_of(list->values(), legal) ? std::optional<ParameterValue>(*list) : std::nullopt;
}

std::optional<ParameterValue> legal_value(const Parameter& parameter, const ParameterValue& value) {
  switch (parameter.kind) {
    case ParameterKind::number:
      if (const auto number = number_equal_to(parameter, value)) return number;
      return choice_equal_to(parameter, value);
    case ParameterKind::integer:
      if (!std::holds_alternative<std::int64_t>(value) || !number_equal_to(parameter, value)) return std::nullopt;
      return value;
    case ParameterKind::integers:
      if (const auto list = integers_equal_to(parameter, value)) return list;
      return choice_equal_to(parameter, value);
    case ParameterKind::boolean:
      return std::holds_alternative<bool>(value) ? std::optional(value) : std::nullopt;
    case ParameterKind::choice:
      break;
  }
  return choice_equal_to(parameter, value);
}

}  // namespace

bool Bounds::contains(double value) const {
  const bool above = low_open ? value > low : value >= low;
  const bool below = high_open ? value < high : value <= high;
  return std::isfinite(value) && above && below;
}

std::string to_string(const Bounds& bounds) {
  const bool has_low = std::isfinite(bounds.low);
  const bool has_high = std::isfinite(bounds.high);
  if (!has_low && !has_high) return "finite";
  if (has_low && has_high && !bounds.low_open && !bounds.high_open) {
    return fmt::format("from {} to {}", bounds.low, bounds.high);
  }
  std::string low = fmt::format("{} {}", bounds.low_open ? "above" : "at least", bounds.low);
  std::string high = fmt::format("{} {}", bounds.high_open ? "below" : "at most", bounds.high);
  if (!has_high) return low;
  return has_low ? low + " and " + high : high;
}

void require_in_bounds(std::string_view what, double value, const Bounds& bounds) {
  if (!bounds.contains(value)) {
    throw InputError(fmt::format("{} is {}; it must be {}", what, value, to_string(bounds)));
  }
}

std::string unit_phrase(const Parameter& parameter) {
  return parameter.unit.empty() ? "" : fmt::format(", in {}", parameter.unit);
}

std::string legal_values(const Parameter& parameter) {
  const std::string words = fmt::format("{}", fmt::join(parameter.choices, ", "));
  switch (parameter.kind) {
    case ParameterKind::number:
      return bounded("number", parameter) + (words.empty() ? "" : ", or " + words);
    case ParameterKind::integer:
      return bounded("whole number", parameter);
    case ParameterKind::integers:
      return fmt::format("{}, a list of up to {}{}", bounded("whole number", parameter), IntegerList::most,
                         words.empty() ? "" : ", or " + words);
    case ParameterKind::boolean:
      return "true or false";
    case ParameterKind::choice:
      break;
  }
  return "one of " + words;
}

std::optional<std::string_view> choice_of(const Parameter& parameter, std::string_view word) {
  const auto found = std::ranges::find(parameter.choices, word);
  return found == parameter.choices.end() ? std::nullopt : std::optional(*found);
}

ParameterValue validate_value(const Parameter& parameter, const ParameterValue& value) {
  if (const std::optional<ParameterValue> legal = legal_value(parameter, value)) return *legal;
  std::string legal = legal_values(parameter);
  if (const auto* const word = std::get_if<std::string_view>(&value)) {
    const std::vector<std::string> choices(parameter.choices.begin(), parameter.choices.end());
    if (const auto meant = nearest_word(*word, choices)) legal += fmt::format("; did you mean \"{}\"?", *meant);
  }
  fail_value(parameter, shown(value), legal);
}

ParameterValue parse_value(const Parameter& parameter, std::string_view text) {
  if (parameter.kind == ParameterKind::boolean && (text == "true" || text == "false")) return text == "true";
  if (const auto choice = choice_of(parameter, text)) return validate_value(parameter, *choice);
  if (parameter.kind == ParameterKind::number) {
    if (const auto number = parse_number(text)) return validate_value(parameter, *number);
  } else if (const auto numbers = whole_numbers(text)) {
    const bool one = numbers->size() == 1;
    return validate_value(parameter, one ? ParameterValue(numbers->front()) : IntegerList(std::span(*numbers)));
  }
  return validate_value(parameter, text);
}

std::string to_string(const ParameterValue& value) {
  return std::visit(
      [](const auto& v) -> std::string {
        using Value = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<Value, std::monostate>) return "";
        if constexpr (std::is_same_v<Value, std::string_view>) return std::string(v);
        if constexpr (std::is_arithmetic_v<Value>) return fmt::format("{}", v);
        if constexpr (std::is_same_v<Value, IntegerList>) return fmt::format("{}", fmt::join(v.values(), ","));
      },
      value);
}

ParameterValues::ParameterValues(std::span<const Parameter> parameters) : parameters_(parameters) {
  std::ranges::transform(parameters, std::back_inserter(values_), &Parameter::default_value);
}

void ParameterValues::set(std::string_view name, const ParameterValue& value) {
  const auto found = std::ranges::find(parameters_, name, &Parameter::name);
  if (found == parameters_.end()) {
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters_) names.emplace_back(parameter.name);
    throw InputError(fmt::format("there is no setting {}{}", quoted_word(name), suggestion(name, names)));
  }
  values_[static_cast<std::size_t>(found - parameters_.begin())] = validate_value(*found, value);
}

void ParameterValues::require_complete() const {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (std::holds_alternative<std::monostate>(values_[i])) {
      fail_value(parameters_[i], "missing", legal_values(parameters_[i]));
    }
  }
}

const ParameterValue* ParameterValues::find(std::string_view name) const {
  const auto found = std::ranges::find(parameters_, name, &Parameter::name);
  return found == parameters_.end() ? nullptr : &values_[static_cast<std::size_t>(found - parameters_.begin())];
}

const ParameterValue& ParameterValues::value(std::string_view name) const {
  if (const ParameterValue* const found = find(name)) return *found;
  throw InputError(fmt::format("there is no parameter {}", quoted_word(name)));
}

}  // namespace shapegauge

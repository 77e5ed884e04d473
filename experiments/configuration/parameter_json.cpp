// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/parameter_json.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace shapegauge {

namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

/// Converts an array to a list of integers; none for an empty array and for other or too many elements.
ParameterValue integer_list(const Json& array) {
  const auto is_whole = [](const Json& value) {
    return value.is_number_integer() &&
           !(value.is_number_unsigned() && value.get<std::uint64_t>() > std::numeric_limits<std::int64_t>::max());
  };
  if (array.empty() || array.size() > IntegerList::most || !std::all_of(array.begin(), array.end(), is_whole))
    return {};
  return IntegerList(std::span<const std::int64_t>(array.get<std::vector<std::int64_t>>()));
}

/// Converts a JSON value. Refers to the text of a string. A value of an unsupported kind becomes none.
ParameterValue parameter_value(const Json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_string()) return std::string_view(value.get_ref<const std::string&>());
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > std::numeric_limits<std::int64_t>::max()) {
    return value.get<double>();
  }
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  if (value.is_array()) return integer_list(value);
  return {};
}

template <typename AnyJson>
AnyJson json_of(const ParameterValue& value) {
  return std::visit(
      [](const auto& v) -> AnyJson {
        using Value = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<Value, std::monostate>) {
          return nullptr;
        } else if constexpr (std::is_same_v<Value, IntegerList>) {
          if (v.values().size() == 1) return v.values().front();
          return std::vector<std::int64_t>(v.values().begin(), v.values().end());
        } else {
          return AnyJson(v);
        }
      },
      value);
}

/// Formats a bound as people write it: 1, not 1.0.
OrderedJson number_json(double bound) {
  constexpr double exact = 9007199254740992.0;  // 2^53
  if (bound == std::floor(bound) && std::abs(bound) <= exact) return static_cast<std::int64_t>(bound);
  return bound;
}

void add_bounds(const Bounds& bounds, OrderedJson& schema) {
  if (std::isfinite(bounds.low)) schema[bounds.low_open ? "exclusiveMinimum" : "minimum"] = number_json(bounds.low);
  if (std::isfinite(bounds.high)) schema[bounds.high_open ? "exclusiveMaximum" : "maximum"] = number_json(bounds.high);
}

OrderedJson number_schema(const Parameter& parameter) {
  OrderedJson schema{{"type", parameter.kind == ParameterKind::number ? "number" : "integer"}};
  add_bounds(parameter.bounds, schema);
  return schema;
}

/// Describes the parameter's values in Markdown: "integer from 1 to 9".
std::string markdown_values(const Parameter& parameter) {
  std::string words = fmt::format("`{}`", fmt::join(parameter.choices, "`, `"));
  switch (parameter.kind) {
    case ParameterKind::boolean:
      return "true or false";
    case ParameterKind::choice:
      return words;
    case ParameterKind::integer:
      return "integer " + to_string(parameter.bounds) + unit_phrase(parameter);
    case ParameterKind::integers:
      return fmt::format("integer {}{}, a list of up to {}{}", to_string(parameter.bounds), unit_phrase(parameter),
                         IntegerList::most, parameter.choices.empty() ? "" : ", or " + words);
    case ParameterKind::number:
      break;
  }
  return "number " + to_string(parameter.bounds) + unit_phrase(parameter) +
         (parameter.choices.empty() ? "" : ", or " + words);
}

std::string default_text(const Parameter& parameter) {
  if (parameter.required()) return "required";
  if (const auto* word = std::get_if<std::string_view>(&parameter.default_value)) return fmt::format("`{}`", *word);
  if (const auto* number = std::get_if<double>(&parameter.default_value)) return fmt::format("{:g}", *number);
  return json_of<Json>(parameter.default_value).dump();
}

}  // namespace

ParameterValues read_parameters(std::span<const Parameter> parameters, const Json& settings) {
  ParameterValues values(parameters);
  for (const Parameter& parameter : parameters) {
    const auto setting = settings.find(parameter.name);
    if (setting != settings.end()) values.set(parameter.name, parameter_value(*setting));
  }
  values.require_complete();
  return values;
}

ParameterValues read_only_parameters(std::span<const Parameter> parameters, const Json& settings) {
  ParameterValues values(parameters);
  for (const auto& [name, value] : settings.items()) values.set(name, parameter_value(value));
  values.require_complete();
  return values;
}

Json to_json(const ParameterValues& values) {
  Json json = Json::object();
  for (const Parameter& parameter : values.parameters()) {
    json[std::string(parameter.name)] = json_of<Json>(values.value(parameter.name));
  }
  return json;
}

namespace {

/// Extends a schema by lists of its values, if the parameter takes lists.
OrderedJson with_lists(const Parameter& parameter, const OrderedJson& one) {
  if (parameter.kind != ParameterKind::integers) return one;
  return {{"if", {{"type", "array"}}},
          {"then", {{"minItems", 1}, {"maxItems", IntegerList::most}, {"items", one}}},
          {"else", one}};
}

/// Extends a schema by words.
OrderedJson with_words(const OrderedJson& words, const OrderedJson& other) {
  if (words.empty()) return other;
  return {{"if", {{"type", "string"}}}, {"then", {{"enum", words}}}, {"else", other}};
}

}  // namespace

OrderedJson schema_of(const Parameter& parameter) {
  OrderedJson schema{{"description", parameter.unit.empty()
                                         ? std::string(parameter.description)
                                         : fmt::format("{} Unit: {}.", parameter.description, parameter.unit)}};
  const OrderedJson words(std::vector<std::string_view>(parameter.choices.begin(), parameter.choices.end()));
  if (parameter.kind == ParameterKind::boolean) {
    schema["type"] = "boolean";
  } else if (parameter.kind == ParameterKind::choice) {
    schema["enum"] = words;
  } else {
    schema.update(with_words(words, with_lists(parameter, number_schema(parameter))));
  }
  if (!parameter.required()) {
    const auto* number = std::get_if<double>(&parameter.default_value);
    schema["default"] = number != nullptr ? number_json(*number) : json_of<OrderedJson>(parameter.default_value);
  }
  return schema;
}

std::string markdown_list(std::span<const Parameter> parameters) {
  std::string list;
  for (const Parameter& parameter : parameters) {
    const std::string default_remark = (parameter.required() ? "" : "default ") + default_text(parameter);
    list += fmt::format("- `{}` ({}; {}): {}\n", parameter.name, markdown_values(parameter), default_remark,
                        parameter.description);
  }
  return list;
}

}  // namespace shapegauge

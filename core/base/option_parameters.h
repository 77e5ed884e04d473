// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/base/words.h"

/// Tables of options: each entry names a member of an options struct, its bounds and its meaning. Defaults are those of
/// the struct. Each option is thus specified in one place.

namespace shapegauge {

/// Describes a member of an options struct as a Parameter, with functions that read and set the member.
template <typename Options>
struct OptionParameter {
  Parameter parameter;                           ///< name, default, bounds and description of the option
  ParameterValue (*value)(const Options&);       ///< returns the value of the member
  void (*set)(Options&, const ParameterValue&);  ///< assigns a value to the member
};

/// Type trait of a pointer to member: its struct (Options) and the type of the member (Value).
template <typename Member>
struct MemberOf;
template <typename OptionsOf, typename ValueOf>
struct MemberOf<ValueOf OptionsOf::*> {
  using Options = OptionsOf;  ///< struct that has the member
  using Value = ValueOf;      ///< type of the member
};

/// True for integer types other than bool; parameters store these in 64 bits.
template <typename Value>
inline constexpr bool is_integer = std::is_integral_v<Value> && !std::is_same_v<Value, bool>;

/// Type in which a ParameterValue stores a member of type Value: a word for an enumeration, 64 bits for an integer, and
/// Value itself otherwise.
template <typename Value>
using StoredValue = std::conditional_t<is_integer<Value>, std::int64_t,
                                       std::conditional_t<std::is_enum_v<Value>, std::string_view, Value>>;

/// Converts the value of a member of an options struct to the type that a ParameterValue stores.
template <typename Value>
constexpr StoredValue<Value> to_parameter_value(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return word_of(value);
  } else {
    return static_cast<StoredValue<Value>>(value);
  }
}

/// Converts a parameter's value to `Value`, the type of a member of an options struct. A word becomes an enumeration
/// value or, if `Value` is IntegerList, the empty list.
template <typename Value>
Value member_value(const ParameterValue& value) {
  if constexpr (std::is_same_v<Value, IntegerList>) {
    const auto* const list = std::get_if<IntegerList>(&value);
    return list != nullptr ? *list : IntegerList{};
  } else if constexpr (std::is_enum_v<Value>) {
    return value_of_word<Value>(std::get<std::string_view>(value)).value();
  } else {
    return static_cast<Value>(std::get<StoredValue<Value>>(value));
  }
}

/// Makes an OptionParameter for a member of an options struct: an integer, an IntegerList, a double, a bool or an
/// enumeration with words_of. For an IntegerList, every word in `choices`, such as "auto", stands for the empty list.
template <auto member>
constexpr auto option_of(std::string_view name, Bounds bounds, std::string_view description,
                         std::span<const std::string_view> choices = {}) {
  using Options = typename MemberOf<decltype(member)>::Options;
  using Value = typename MemberOf<decltype(member)>::Value;
  constexpr bool is_list = std::is_same_v<Value, IntegerList>;
  constexpr bool is_word = std::is_enum_v<Value>;
  static_assert(is_list || is_word || is_integer<Value> || std::is_same_v<Value, double> ||
                std::is_same_v<Value, bool>);
  if constexpr (is_word) {
    static_assert(words_of<Value>.size() > 0);
    choices = words_of<Value>;
  }
  return OptionParameter<Options>{
      .parameter = {.name = name,
                    .kind = is_list                         ? ParameterKind::integers
                            : is_word                       ? ParameterKind::choice
                            : is_integer<Value>             ? ParameterKind::integer
                            : std::is_same_v<Value, double> ? ParameterKind::number
                                                            : ParameterKind::boolean,
                    .default_value = to_parameter_value(Options{}.*member),
                    .bounds = bounds,
                    .choices = choices,
                    .description = description},
      .value = [](const Options& options) { return ParameterValue(to_parameter_value(options.*member)); },
      .set = [](Options& options, const ParameterValue& value) { options.*member = member_value<Value>(value); }};
}

/// Makes an OptionParameter for a bool or an enumeration, which have no bounds.
template <auto member>
constexpr auto option_of(std::string_view name, std::string_view description) {
  return option_of<member>(name, Bounds{}, description);
}

/// Removes the default of an option, which makes the option mandatory.
template <typename Options>
constexpr OptionParameter<Options> without_default(OptionParameter<Options> option) {
  option.parameter.default_value = {};
  return option;
}

/// Adds a unit (Parameter::unit) to an option.
template <typename Options>
constexpr OptionParameter<Options> with_unit(std::string_view unit, OptionParameter<Options> option) {
  option.parameter.unit = unit;
  return option;
}

/// Replaces the description of an option, for a table that needs a different one.
template <typename Options>
constexpr OptionParameter<Options> with_description(std::string_view description, OptionParameter<Options> option) {
  option.parameter.description = description;
  return option;
}

/// Makes an OptionParameter for an option of the nested options struct `member`: entry `index` of `table`, the nested
/// struct's table.
template <auto member, const auto& table, std::size_t index>
constexpr auto nested_option() {
  using Options = typename MemberOf<decltype(member)>::Options;
  return OptionParameter<Options>{
      .parameter = table.at(index).parameter,
      .value = [](const Options& options) { return table.at(index).value(options.*member); },
      .set = [](Options& options, const ParameterValue& value) { table.at(index).set(options.*member, value); }};
}

/// Returns the Parameter of each entry of a table of options, in order.
template <typename Options, std::size_t count>
constexpr std::array<Parameter, count> parameters_of(const std::array<OptionParameter<Options>, count>& table) {
  return [&]<std::size_t... indices>(std::index_sequence<indices...>) {
    return std::array<Parameter, count>{table[indices].parameter...};
  }
  (std::make_index_sequence<count>());
}

/// Returns the Parameter called `name` of a table of options. The table must contain it.
template <typename Options, std::size_t count>
constexpr const Parameter& parameter_named(std::string_view name,
                                           const std::array<OptionParameter<Options>, count>& table) {
  std::size_t index = 0;
  while (table.at(index).parameter.name != name) ++index;
  return table.at(index).parameter;
}

/// Validates options against the bounds of their table. Throws ArgumentError, prefixed by `what`, for an invalid
/// option.
template <typename Options, std::size_t count>
void check_options(std::string_view what, const std::array<OptionParameter<Options>, count>& table,
                   const Options& options) {
  for (const auto& option : table) {
    try {
      validate_value(option.parameter, option.value(options));
    } catch (const InputError& error) {
      throw ArgumentError(std::string(what) + ": " + error.what());
    }
  }
}

/// Converts an options struct to parameter values. `parameters` are parameters_of() the table and must outlive the
/// result. Throws InputError for a value out of bounds.
template <typename Options, std::size_t count>
ParameterValues values_of(const std::array<Parameter, count>& parameters,
                          const std::array<OptionParameter<Options>, count>& table, const Options& options) {
  ParameterValues values(parameters);
  for (const auto& option : table) values.set(option.parameter.name, option.value(options));
  return values;
}

/// Converts parameter values to an options struct. Every option of the table must have a value.
template <typename Options, std::size_t count>
Options options_from(const std::array<OptionParameter<Options>, count>& table, const ParameterValues& values) {
  Options options;
  for (const auto& option : table) option.set(options, values.value(option.parameter.name));
  return options;
}

}  // namespace shapegauge

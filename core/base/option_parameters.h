#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parameter.h"

/// Structs of options as lists of parameters: a table names members of the struct, one a line, with their bounds and
/// what they mean. Defaults are those of the struct. What the options may be is then said once.

namespace shapegauge {

/// A member of a struct of options, as a parameter.
template <typename Options>
struct OptionParameter {
  Parameter parameter;
  ParameterValue (*value)(const Options&);
  void (*set)(Options&, const ParameterValue&);
};

/// The struct and the type of a pointer to a member.
template <typename Member>
struct MemberOf;
template <typename OptionsOf, typename ValueOf>
struct MemberOf<ValueOf OptionsOf::*> {
  using Options = OptionsOf;
  using Value = ValueOf;
};

/// The words of an enumeration whose values are 0, 1, 2 and so on. Specialised beside each one that options may have.
template <typename Enumeration>
inline constexpr std::array<std::string_view, 0> words_of{};

/// A whole number, which parameters hold with 64 bits.
template <typename Value>
inline constexpr bool is_integer = std::is_integral_v<Value> && !std::is_same_v<Value, bool>;

/// How a parameter holds the value of a member.
template <typename Value>
using HeldValue = std::conditional_t<is_integer<Value>, std::int64_t,
                                     std::conditional_t<std::is_enum_v<Value>, std::string_view, Value>>;

/// A member's value as the parameter holds it.
template <typename Value>
constexpr HeldValue<Value> held_value(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return words_of<Value>.at(static_cast<std::size_t>(value));
  } else {
    return HeldValue<Value>{value};
  }
}

/// The value of a member; a word means the empty list, or the value of an enumeration.
template <typename Value>
Value member_value(const ParameterValue& value) {
  if constexpr (std::is_same_v<Value, IntegerList>) {
    const auto* const list = std::get_if<IntegerList>(&value);
    return list != nullptr ? *list : IntegerList{};
  } else if constexpr (std::is_enum_v<Value>) {
    const auto word = std::ranges::find(words_of<Value>, std::get<std::string_view>(value));
    return static_cast<Value>(word - words_of<Value>.begin());
  } else {
    return static_cast<Value>(std::get<HeldValue<Value>>(value));
  }
}

/// Makes a parameter for a member (a whole number, an IntegerList, a double, a bool, or an enumeration that has
/// words_of) of a struct of options. The choices of a list all mean the empty list.
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
                    .default_value = held_value(Options{}.*member),
                    .bounds = bounds,
                    .choices = choices,
                    .description = description},
      .value = [](const Options& options) { return ParameterValue(held_value(options.*member)); },
      .set = [](Options& options, const ParameterValue& value) { options.*member = member_value<Value>(value); }};
}

/// The same for a bool or an enumeration.
template <auto member>
constexpr auto option_of(std::string_view name, std::string_view description) {
  return option_of<member>(name, Bounds{}, description);
}

/// The same option without a default: whoever chooses the options must give it.
template <typename Options>
constexpr OptionParameter<Options> required(OptionParameter<Options> option) {
  option.parameter.default_value = {};
  return option;
}

/// An option of a struct that is itself a member of a struct of options. `table`: that of the member's own type.
template <auto member, const auto& table, std::size_t index>
constexpr auto option_within() {
  using Options = typename MemberOf<decltype(member)>::Options;
  return OptionParameter<Options>{
      .parameter = table.at(index).parameter,
      .value = [](const Options& options) { return table.at(index).value(options.*member); },
      .set = [](Options& options, const ParameterValue& value) { table.at(index).set(options.*member, value); }};
}

/// The parameters of a table of options.
template <typename Options, std::size_t count>
constexpr std::array<Parameter, count> parameters_of(const std::array<OptionParameter<Options>, count>& table) {
  return [&]<std::size_t... indices>(std::index_sequence<indices...>) {
    return std::array<Parameter, count>{table[indices].parameter...};
  }
  (std::make_index_sequence<count>());
}

/// Throws InputError, beginning with `what`, where a value of the options is out of the table's bounds.
template <typename Options, std::size_t count>
void check_options(std::string_view what, const std::array<OptionParameter<Options>, count>& table,
                   const Options& options) {
  for (const auto& option : table) {
    try {
      checked_value(option.parameter, option.value(options));
    } catch (const InputError& error) {
      throw InputError(std::string(what) + ": " + error.what());
    }
  }
}

/// The options of the values of the table's parameters.
template <typename Options, std::size_t count>
Options options_from(const std::array<OptionParameter<Options>, count>& table, const ParameterValues& values) {
  Options options;
  for (const auto& option : table) option.set(options, values.value(option.parameter.name));
  return options;
}

}  // namespace shapegauge

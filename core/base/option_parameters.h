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

/// How a parameter holds the value of a member.
template <typename Value>
using HeldValue = std::conditional_t<std::is_same_v<Value, int>, std::int64_t, Value>;

/// The value of a member; a word means the empty list.
template <typename Value>
Value member_value(const ParameterValue& value) {
  if constexpr (std::is_same_v<Value, IntegerList>) {
    const auto* const list = std::get_if<IntegerList>(&value);
    return list != nullptr ? *list : IntegerList{};
  } else {
    return static_cast<Value>(std::get<HeldValue<Value>>(value));
  }
}

/// Makes a parameter for a member (an int, an IntegerList, a double or a bool) of a struct of options. The choices of a
/// list all mean the empty list.
template <auto member>
constexpr auto option_of(std::string_view name, Bounds bounds, std::string_view description,
                         std::span<const std::string_view> choices = {}) {
  using Options = typename MemberOf<decltype(member)>::Options;
  using Value = typename MemberOf<decltype(member)>::Value;
  constexpr bool is_list = std::is_same_v<Value, IntegerList>;
  static_assert(is_list || std::is_same_v<Value, int> || std::is_same_v<Value, double> || std::is_same_v<Value, bool>);
  using Held = HeldValue<Value>;
  return OptionParameter<Options>{
      .parameter = {.name = name,
                    .kind = is_list                         ? ParameterKind::integers
                            : std::is_same_v<Value, int>    ? ParameterKind::integer
                            : std::is_same_v<Value, double> ? ParameterKind::number
                                                            : ParameterKind::boolean,
                    .default_value = Held{Options{}.*member},
                    .bounds = bounds,
                    .choices = choices,
                    .description = description},
      .value = [](const Options& options) { return ParameterValue(Held{options.*member}); },
      .set = [](Options& options, const ParameterValue& value) { options.*member = member_value<Value>(value); }};
}

/// The same for a bool.
template <auto member>
constexpr auto option_of(std::string_view name, std::string_view description) {
  return option_of<member>(name, Bounds{}, description);
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

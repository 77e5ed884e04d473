// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/parameter.h"

namespace shapegauge {

/// Reads the values of parameters from an object of settings, with defaults for missing ones. Ignores other keys.
/// Throws InputError for an invalid value and for a missing mandatory one.
ParameterValues read_parameters(std::span<const Parameter> parameters, const nlohmann::json& settings);

/// Reads the values of parameters from an object without other keys. Throws InputError as read_parameters() does, and
/// for another key.
ParameterValues read_only_parameters(std::span<const Parameter> parameters, const nlohmann::json& settings);

/// Formats the values by name, as read_parameters() takes them.
nlohmann::json to_json(const ParameterValues& values);

/// Reads options by the names of their table, with defaults for missing ones. Throws InputError as read_parameters()
/// does.
template <typename Options, std::size_t count>
Options read_options(const std::array<OptionParameter<Options>, count>& table, const nlohmann::json& settings) {
  const std::array<Parameter, count> parameters = parameters_of(table);
  return options_from(table, read_parameters(parameters, settings));
}

/// Formats options by the names of their table, as read_options() takes them.
template <typename Options, std::size_t count>
nlohmann::json options_json(const std::array<OptionParameter<Options>, count>& table, const Options& options) {
  const std::array<Parameter, count> parameters = parameters_of(table);
  return to_json(values_of(parameters, table, options));
}

/// Returns the JSON Schema (draft 7) of a parameter's value.
nlohmann::ordered_json schema_of(const Parameter& parameter);

/// Formats a Markdown list that documents parameters: key, valid values, default, meaning.
std::string markdown_list(std::span<const Parameter> parameters);

/// Formats a Markdown table that documents parameters: key, meaning with the valid values, default.
std::string markdown_table(std::span<const Parameter> parameters);

}  // namespace shapegauge

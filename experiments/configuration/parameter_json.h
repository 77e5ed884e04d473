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

/// Reads the values of parameters from an object that has no other keys. Throws InputError as read_parameters() does,
/// and for an unknown key.
ParameterValues read_only_parameters(std::span<const Parameter> parameters, const nlohmann::json& settings);

/// Formats parameter values as a JSON object with the names as keys, as read_parameters() reads it.
nlohmann::json to_json(const ParameterValues& values);

/// Reads a struct of options from an object whose keys are the names in `table`, with defaults for missing keys. Throws
/// InputError as read_parameters() does.
template <typename Options, std::size_t count>
Options read_options(const std::array<OptionParameter<Options>, count>& table, const nlohmann::json& settings) {
  const std::array<Parameter, count> parameters = parameters_of(table);
  return options_from(table, read_parameters(parameters, settings));
}

/// Formats a struct of options as an object whose keys are the names in `table`, as read_options() reads it. Returns
/// nlohmann::json, as `auto` since that is declared only.
template <typename Options, std::size_t count>
auto options_json(const std::array<OptionParameter<Options>, count>& table, const Options& options) {
  const std::array<Parameter, count> parameters = parameters_of(table);
  return to_json(values_of(parameters, table, options));
}

/// Returns the JSON Schema (draft 7) of a parameter's value.
nlohmann::ordered_json schema_of(const Parameter& parameter);

/// Formats a Markdown list that documents parameters: key, valid values, default, meaning.
std::string markdown_list(std::span<const Parameter> parameters);

}  // namespace shapegauge

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "shapegauge/core/base/parameter.h"

namespace shapegauge {

/// Reads the values of parameters from an object of settings, with defaults for missing ones. Ignores other keys.
/// Throws InputError for an invalid value and for a missing mandatory one.
ParameterValues read_parameters(std::span<const Parameter> parameters, const nlohmann::json& settings);

/// Formats the values by name, as read_parameters() takes them.
nlohmann::json to_json(const ParameterValues& values);

/// Returns the JSON Schema (draft 7) of a parameter's value.
nlohmann::ordered_json schema_of(const Parameter& parameter);

/// Formats a Markdown table that documents parameters: key, meaning with the valid values, default.
std::string markdown_table(std::span<const Parameter> parameters);

}  // namespace shapegauge

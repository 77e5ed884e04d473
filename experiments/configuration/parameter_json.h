#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "shapegauge/core/base/parameter.h"

namespace shapegauge {

/// Reads a value for each parameter from an object of settings; those that are absent get their defaults. Keys that are
/// no parameters are left to others. Throws InputError for a value that the parameter does not take, and for one that
/// is required and absent.
ParameterValues read_parameters(std::span<const Parameter> parameters, const nlohmann::json& settings);

/// The values by name, in the form that read_parameters() takes.
nlohmann::json to_json(const ParameterValues& values);

/// What a JSON Schema (draft 7) says of the parameter's value.
nlohmann::ordered_json schema_of(const Parameter& parameter);

/// A table in Markdown that documents the parameters: key, meaning with the legal values, default.
std::string markdown_table(std::span<const Parameter> parameters);

}  // namespace shapegauge

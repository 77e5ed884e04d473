#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace shapegauge {

/// Holds a configuration to the experiment schema. Throws InputError for the first thing that is wrong, most telling
/// first: an unknown key, with the nearest known one; then what is deepest in the document. The message gives the
/// source, the path as `--set` writes it, what is wrong and what is allowed.
void check_against_schema(const nlohmann::json& configuration, const std::string& source);

}  // namespace shapegauge

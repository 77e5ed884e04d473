// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace shapegauge {

/// Returns the value with all names and strings as with_escaped_bytes(): names of files need not be UTF-8, as JSON is.
/// @{
nlohmann::json escaped_json(const nlohmann::json& value);
nlohmann::ordered_json escaped_json(const nlohmann::ordered_json& value);
/// @}

/// Formats a JSON value as escaped_json(): on one line, or indented by a number of blanks.
/// @{
std::string json_text(const nlohmann::json& value, int indent = -1);
std::string json_text(const nlohmann::ordered_json& value, int indent = -1);
/// @}

}  // namespace shapegauge

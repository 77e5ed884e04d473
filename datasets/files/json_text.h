// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace shapegauge {

/// Returns the value with invalid UTF-8 in all names and strings escaped by with_escaped_bytes(), since JSON is UTF-8.
/// @{
nlohmann::json escaped_json(const nlohmann::json& value);
nlohmann::ordered_json escaped_json(const nlohmann::ordered_json& value);
/// @}

/// Formats a JSON value after escaped_json(): on one line if `indent` is negative, else indented by `indent` blanks.
/// @{
std::string json_text(const nlohmann::json& value, int indent = -1);
std::string json_text(const nlohmann::ordered_json& value, int indent = -1);
/// @}

}  // namespace shapegauge

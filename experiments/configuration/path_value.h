#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace shapegauge {

/// The path that is the value of the object's key, variables expanded, relative to the folder. Throws MisplacedValue
/// where a variable is not set.
std::filesystem::path path_value(const nlohmann::json& object, const std::string& key,
                                 const std::filesystem::path& folder);

}  // namespace shapegauge

#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace shapegauge {

/// The JSON value that the text holds. Throws InputError for text that is not JSON, with line and column, and for a key
/// that stands twice in one object. `source` is what messages call the text, such as the name of its file.
nlohmann::json parse_json(std::string_view text, const std::string& source);

/// The same for a file. Throws InputError where it cannot be read, too.
nlohmann::json read_json(const std::filesystem::path& path);

}  // namespace shapegauge

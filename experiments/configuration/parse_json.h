#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace shapegauge {

/// The JSON value that the text holds. Throws InputError for text that is not JSON, with line and column, for a key
/// that stands twice in one object, and for values nested more than 100 deep. `source` is what messages call the text,
/// such as the name of its file.
nlohmann::json parse_json(std::string_view text, const std::string& source);

/// The same, but nothing where the text is not JSON.
std::optional<nlohmann::json> parse_if_json(std::string_view text, const std::string& source);

/// The same as parse_json for a file. Throws InputError where it cannot be read, too.
nlohmann::json read_json(const std::filesystem::path& path);

}  // namespace shapegauge

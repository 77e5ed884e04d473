#pragma once

#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

/// An error at a place within the part of a configuration that is being looked at.
struct ConfigurationError {
  std::string path;
  std::string message;
};

/// Runs a step on the part of the document at a key (or index, or dotted path), and completes the place where it fails.
template <typename Step>
auto at(const std::string& key, Step step) {
  try {
    return step();
  } catch (const ConfigurationError& error) {
    throw ConfigurationError{fmt::format("{}.{}", key, error.path), error.message};
  } catch (const InputError& error) {
    throw ConfigurationError{key, error.what()};
  }
}

/// The JSON value that the text holds. Throws InputError for text that is not JSON, with line and column, for a key
/// that stands twice in one object, and for values nested more than 100 deep. `source` is what messages call the text,
/// such as the name of its file.
nlohmann::json parse_json(std::string_view text, const std::string& source);

/// The same, but nothing where the text is not JSON.
std::optional<nlohmann::json> parse_if_json(std::string_view text, const std::string& source);

/// The same as parse_json for a file. Throws InputError where it cannot be read, too.
nlohmann::json read_json(const std::filesystem::path& path);

/// The text with every `${NAME}` replaced by the environment variable NAME. Throws InputError where a variable is not
/// set or is empty (the message says to set it), or where a `${` has no `}`.
std::string expand_variables(std::string_view text);

/// The path that is the value of the object's key, variables expanded, relative to the folder. Throws
/// ConfigurationError where a variable is not set.
std::filesystem::path path_value(const nlohmann::json& object, const std::string& key,
                                 const std::filesystem::path& folder);

/// Changes one value of a document as `--set` says it: `dotted.key=value`, where a key of an array is an index
/// (`signatures.0.histogram.bins=40`), or the name of its element in brackets (`signatures["Sum"].scale=local`; the
/// quotation marks may be left out). The value is JSON where it parses as JSON, else a string. Objects that are absent
/// on the way are made. Throws InputError for an assignment without key or `=`, an index beyond the array, a name that
/// no element has, a key that leads into something that is neither object nor array, bytes that are not UTF-8, or a
/// value in JSON that parse_json would refuse. Returns the place of the value.
nlohmann::json::json_pointer apply_override(nlohmann::json& document, std::string_view assignment);

}  // namespace shapegauge

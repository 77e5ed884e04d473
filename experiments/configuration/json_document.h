// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

/// Error in a configuration, with the path of the faulty value within the section being read. what() returns "path:
/// message".
class ConfigurationError : public InputError {
 public:
  /// `at` is the path of the faulty value; `fault` describes the fault.
  ConfigurationError(std::string_view at, std::string_view fault)
      : InputError(std::string(at).append(": ").append(printable(fault, max_length))),
        path(at),
        message(printable(fault, max_length)) {}

  std::string path;     ///< path of the faulty value, such as "histogram.bins"
  std::string message;  ///< description of the fault

 private:
  static constexpr std::size_t max_length = 500;  ///< maximum length of messages in characters
};

/// Calls step(), which reads the value at a key (or index, or dotted path) of a document, and returns its result.
/// Prefixes the key to the path of a ConfigurationError, and turns any other InputError into a ConfigurationError at
/// the key.
template <typename Step>
auto at_key(const std::string& key, Step step) {
  try {
    return step();
  } catch (const ConfigurationError& error) {
    throw ConfigurationError{key + "." + error.path, error.message};
  } catch (const InputError& error) {
    throw ConfigurationError{key, error.what()};
  }
}

/// Formats a JSON pointer in the notation of the option `--set`: "/datasets/0/root" becomes "datasets.0.root".
std::string dotted(const nlohmann::json_pointer<std::string>& pointer);

/// Parses a JSON text, which may have comments (`//` and `/* */`). Throws InputError for invalid JSON, with line and
/// column, for a repeated key of an object, and for values nested more than 100 deep. `source`, such as the name of the
/// file, is the text's name in messages.
nlohmann::json parse_json(std::string_view text, const std::string& source);

/// Parses a JSON text, which may have comments; returns nothing if it is not JSON. Throws InputError as parse_json()
/// does for repeated keys and deep nesting.
std::optional<nlohmann::json> parse_if_json(std::string_view text, const std::string& source);

/// Reads and parses a JSON file. Throws InputError if the file cannot be read, and as parse_json() does.
nlohmann::json read_json(const std::filesystem::path& path);

/// Replaces every `${NAME}` by the environment variable NAME. Throws InputError if a variable is not set or is empty
/// (the message says to set it), or if a `${` has no `}`.
std::string expand_variables(std::string_view text);

/// Returns the file path stored in an object at `key`: `${NAME}` is expanded (expand_variables()), and a relative path
/// is relative to `folder`. Throws ConfigurationError for a variable that is not set.
std::filesystem::path path_value(const nlohmann::json& object, const std::string& key,
                                 const std::filesystem::path& folder);

/// Applies an assignment `dotted.key=value` of the option `--set` to a document. A key of an array is an index
/// (`signatures.0.histogram.bins=40`) or the name of an element in brackets (`signatures["Sum"].scale=local`; the
/// quotation marks are optional). The value is JSON if it parses as JSON, otherwise a string. Missing objects on the
/// path are created. Returns the JSON pointer to the value. Throws InputError for an assignment without key or `=`, an
/// index out of range, an unknown name, a key into something that is neither object nor array, bytes that are not
/// UTF-8, and a value that parse_json() rejects.
nlohmann::json_pointer<std::string> apply_override(nlohmann::json& document, std::string_view assignment);

}  // namespace shapegauge

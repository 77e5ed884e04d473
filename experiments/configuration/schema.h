#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// The JSON Schema (draft 7) of an experiment's configuration: the text of configs/experiment.schema.json.
std::string_view experiment_schema();

/// What a schema allows at one place of a document, as far as an error message can use it.
struct SchemaHints {
  std::vector<std::string> keys;   ///< properties that are known there
  std::vector<std::string> words;  ///< values of an enumeration of strings
  std::vector<std::string> types;  ///< JSON Schema's names of types
};

/// Collects the hints at the path (keys and indices from the root) of the document. Understands what the project's own
/// schema uses: $ref within the schema, properties, items, allOf, and if-then-else whose condition is the presence of a
/// key, the type of the value, or a constant value of a key.
SchemaHints schema_hints(const nlohmann::json& schema, const nlohmann::json& document,
                         const std::vector<std::string>& path);

/// Holds a configuration to the experiment schema. Throws InputError for the first thing that is wrong, most telling
/// first: an unknown key, with the nearest known one; then what is deepest in the document. The message gives the
/// source, the path as `--set` writes it, what is wrong and what is allowed.
void check_against_schema(const nlohmann::json& configuration, const std::string& source);

}  // namespace shapegauge

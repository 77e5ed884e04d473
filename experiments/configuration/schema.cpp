#include "shapegauge/experiments/configuration/schema.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <string_view>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/configuration/nearest_word.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

/// The value of a key, or an empty value where the key is absent.
const Json& part(const Json& schema, const char* key) {
  static const Json none;
  const auto found = schema.find(key);
  return found == schema.end() ? none : *found;
}

bool has_type(const Json& instance, const std::string& type) {
  return (type == "object" && instance.is_object()) || (type == "array" && instance.is_array()) ||
         (type == "string" && instance.is_string()) || (type == "number" && instance.is_number()) ||
         (type == "integer" && instance.is_number_integer()) || (type == "boolean" && instance.is_boolean());
}

/// Whether the instance meets a condition of the simple kinds that the schema uses.
bool meets(const Json& instance, const Json& condition) {
  if (condition.contains("type") && !has_type(instance, condition["type"])) return false;
  for (const Json& key : part(condition, "required")) {
    if (!instance.is_object() || !instance.contains(key.get<std::string>())) return false;
  }
  const auto allowed = part(condition, "properties").items();
  return std::all_of(allowed.begin(), allowed.end(), [&](const auto& property) {
    return !property.value().contains("const") || !instance.is_object() || !instance.contains(property.key()) ||
           instance[property.key()] == property.value()["const"];
  });
}

/// Adds the schema and all that applies to the instance along with it.
void collect(const Json& root, const Json& schema, const Json& instance, std::vector<const Json*>& found) {
  if (schema.contains("$ref")) {
    const std::string reference = schema["$ref"];
    return collect(root, root.at(Json::json_pointer(reference.substr(1))), instance, found);
  }
  found.push_back(&schema);
  for (const Json& conjunct : part(schema, "allOf")) collect(root, conjunct, instance, found);
  if (schema.contains("if")) {
    const char* branch = meets(instance, schema["if"]) ? "then" : "else";
    if (schema.contains(branch)) collect(root, schema[branch], instance, found);
  }
}

std::vector<const Json*> children(const Json& root, const std::vector<const Json*>& schemas, const std::string& key,
                                  const Json& instance) {
  std::vector<const Json*> found;
  for (const Json* schema : schemas) {
    if (schema->contains("properties") && (*schema)["properties"].contains(key)) {
      collect(root, (*schema)["properties"][key], instance, found);
    } else if (schema->contains("items")) {
      collect(root, (*schema)["items"], instance, found);
    }
  }
  return found;
}

void add_once(std::vector<std::string>& words, const std::string& word) {
  if (std::ranges::find(words, word) == words.end()) words.push_back(word);
}

}  // namespace

SchemaHints schema_hints(const Json& schema, const Json& document, const std::vector<std::string>& path) {
  const Json* instance = &document;
  std::vector<const Json*> schemas;
  collect(schema, schema, document, schemas);
  for (const std::string& key : path) {
    instance = instance->is_array() ? &instance->at(std::stoul(key)) : &instance->at(key);
    schemas = children(schema, schemas, key, *instance);
  }
  SchemaHints hints;
  for (const Json* found : schemas) {
    for (const auto& [key, value] : part(*found, "properties").items()) {
      if (!key.starts_with('$')) add_once(hints.keys, key);
    }
    for (const Json& word : part(*found, "enum")) add_once(hints.words, word);
    if (found->contains("type")) add_once(hints.types, (*found)["type"]);
  }
  return hints;
}

namespace {

using Json = nlohmann::json;
using Error = valijson::ValidationResults::Error;

constexpr std::string_view unknown_key = "Object contains a property";
constexpr std::string_view missing_key = "Missing required property";

/// What the validator says about a failure inside, once more, at the levels above it.
bool is_echo(const Error& error) {
  return error.description.starts_with("Failed to validate") &&
         error.description.find("uniqueness") == std::string::npos;
}

/// Keys and indices from the root: the validator writes <root>, ["key"] and [index].
std::vector<std::string> path_of(const Error& error) {
  std::vector<std::string> path;
  for (const std::string& step : error.context) {
    if (!step.starts_with('[')) continue;
    const std::string inner = step.substr(1, step.size() - 2);
    path.push_back(inner.starts_with('"') ? inner.substr(1, inner.size() - 2) : inner);
  }
  return path;
}

/// The last word in single quotes.
std::string quoted_word(const std::string& description) {
  const std::size_t end = description.rfind('\'');
  const std::size_t begin =
      description.find(": '") == std::string::npos ? description.find('\'') + 1 : description.find(": '") + 3;
  return description.substr(begin, end - begin);
}

std::string wrong_value(const Json& value, const SchemaHints& hints) {
  if (!value.is_string()) {
    return fmt::format("must be one of \"{}\", not {}", fmt::join(hints.words, "\", \""), printable(value.dump(), 60));
  }
  return fmt::format("unknown word {}{}", printable(value.dump(), 60),
                     suggestion(value.get<std::string>(), hints.words));
}

/// "Expected number greater than 0.000000" -> "must be a number greater than 0".
std::string wrong_number(std::string description, const Json& value) {
  const std::size_t space = description.rfind(' ');
  const double limit = std::stod(description.substr(space + 1));
  description = description.substr(std::string_view("Expected number ").size(),
                                   space - std::string_view("Expected number ").size());
  return fmt::format("must be a number {} {:g}, not {}", description, limit, printable(value.dump(), 60));
}

std::string describe(const Error& error, const Json& value, const SchemaHints& hints) {
  const std::string& text = error.description;
  if (text.starts_with(unknown_key)) {
    const std::string key = quoted_word(text);
    return fmt::format("unknown key \"{}\"{}", printable(key, 60), suggestion(key, hints.keys));
  }
  if (text.starts_with(missing_key)) return fmt::format("the key \"{}\" is missing", quoted_word(text));
  if (text.find("enum values") != std::string::npos) return wrong_value(value, hints);
  if (text.find("'type' constraint") != std::string::npos) {
    return fmt::format("must be of type {}, not {} ({})", fmt::join(hints.types, " or "), value.type_name(),
                       printable(value.dump(), 60));
  }
  if (text.starts_with("Expected number")) return wrong_number(text, value);
  return fmt::format("{} (found {})", text.substr(0, text.find_last_not_of('.') + 1), printable(value.dump(), 60));
}

/// Rank of an error: the larger, the more it tells.
std::size_t weight(const Error& error) {
  return (error.description.starts_with(unknown_key) ? 1000 : 0) + error.context.size();
}

}  // namespace

void check_against_schema(const Json& configuration, const std::string& source) {
  const Json rules = Json::parse(experiment_schema());
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7)
      .populateSchema(valijson::adapters::NlohmannJsonAdapter(rules), schema);
  valijson::ValidationResults results;
  valijson::Validator validator;
  if (validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(configuration), &results)) return;

  std::optional<Error> worst;
  for (const Error& error : results) {
    if (!is_echo(error) && (!worst || weight(error) > weight(*worst))) worst = error;
  }
  if (!worst) throw InputError(fmt::format("{}: does not match the schema of an experiment", source));
  const std::vector<std::string> path = path_of(*worst);
  const Json* value = &configuration;
  for (const std::string& key : path) value = value->is_array() ? &value->at(std::stoul(key)) : &value->at(key);
  const std::string place = path.empty() ? "" : fmt::format("{}: ", fmt::join(path, "."));
  const std::string message = describe(*worst, *value, schema_hints(rules, configuration, path));
  throw InputError(fmt::format("{}: {}{}", source, printable(place, 200), printable(message, 500)));
}

}  // namespace shapegauge

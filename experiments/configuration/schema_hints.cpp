#include "shapegauge/experiments/configuration/schema_hints.h"

#include <algorithm>

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

}  // namespace shapegauge

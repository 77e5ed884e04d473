// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/nearest_word.h"
#include "shapegauge/experiments/configuration/schema.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;

/// Violation of a schema.
struct Finding {
  std::vector<std::string> path;  ///< keys and indices from the root of the document
  std::string message;
  std::size_t priority = 0;
};

std::string shown(const Json& value) {
  return printable(value.dump(-1, ' ', false, Json::error_handler_t::replace), 60);
}

bool has_type(const Json& value, const std::string& type) {
  return (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
         (type == "string" && value.is_string()) || (type == "number" && value.is_number()) ||
         (type == "integer" && value.is_number_integer()) || (type == "boolean" && value.is_boolean());
}

/// Finds the violations of a schema with their paths. The validator itself only reports that there are some, and prose.
/// Supports the keywords of the experiment schema.
class SchemaWalk {
 public:
  explicit SchemaWalk(const Json& root) : root_(&root) {}

  void visit(const Json& schema, const Json& value) {
    if (schema.contains("$ref")) {
      return visit(root_->at(Json::json_pointer(schema["$ref"].get<std::string>().substr(1))), value);
    }
    if (schema.contains("type") && !has_type(value, schema["type"])) {
      const std::string type = schema["type"];
      return add(fmt::format("must be of type {}, not {} ({})", type, value.type_name(), shown(value)));
    }
    check_words(schema, value);
    if (value.is_number()) check_number(schema, value);
    if (value.is_string()) check_string(schema, value.get_ref<const std::string&>());
    if (value.is_array()) check_array(schema, value);
    if (value.is_object()) check_object(schema, value);
    check_conditions(schema, value);
  }

  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }

 private:
  void add(std::string message) { findings_.push_back({.path = path_, .message = std::move(message)}); }

  [[nodiscard]] bool meets(const Json& value, const Json& schema) const {
    SchemaWalk walk(*root_);
    walk.visit(schema, value);
    return walk.findings_.empty();
  }

  void visit_part(const Json& schema, const Json& value, std::string key) {
    path_.push_back(std::move(key));
    visit(schema, value);
    path_.pop_back();
  }

  void check_words(const Json& schema, const Json& value) {
    if (schema.contains("const") && value != schema["const"]) {
      add(fmt::format("must be {}, not {}", shown(schema["const"]), shown(value)));
    }
    if (!schema.contains("enum") || std::ranges::find(schema["enum"], value) != schema["enum"].end()) return;
    const auto words = schema["enum"].get<std::vector<std::string>>();
    if (value.is_string()) {
      add(fmt::format("unknown word {}{}", shown(value), suggestion(value.get<std::string>(), words)));
    } else {
      add(fmt::format("must be one of \"{}\", not {}", fmt::join(words, "\", \""), shown(value)));
    }
  }

  void check_number(const Json& schema, const Json& value) {
    Bounds bounds;
    const auto read = [&](const char* keyword, double& limit) {
      if (!schema.contains(keyword)) return false;
      limit = schema[keyword];
      return true;
    };
    read("minimum", bounds.low);
    read("maximum", bounds.high);
    bounds.low_open = read("exclusiveMinimum", bounds.low);
    bounds.high_open = read("exclusiveMaximum", bounds.high);
    if (!bounds.contains(value)) add(fmt::format("must be {}, not {}", to_string(bounds), shown(value)));
  }

  void check_string(const Json& schema, const std::string& text) {
    if (text.size() < schema.value("minLength", std::size_t{0})) add("must not be empty");
    if (schema.contains("pattern") && !std::regex_search(text, std::regex(schema["pattern"].get<std::string>()))) {
      add(fmt::format("must match {}", shown(schema["pattern"])));
    }
  }

  void check_array(const Json& schema, const Json& array) {
    const auto least = schema.value("minItems", std::size_t{0});
    const auto most = schema.value("maxItems", array.size());
    if (array.size() < least) add(fmt::format("must have at least {} values, not {}", least, array.size()));
    if (array.size() > most) add(fmt::format("must have at most {} values, not {}", most, array.size()));
    for (std::size_t i = 0; schema.contains("items") && i < array.size(); ++i) {
      visit_part(schema["items"], array[i], std::to_string(i));
    }
    if (!schema.value("uniqueItems", false)) return;
    for (auto value = array.begin(); value != array.end(); ++value) {
      if (std::find(array.begin(), value, *value) != value) add(fmt::format("has {} more than once", shown(*value)));
    }
  }

  void check_object(const Json& schema, const Json& object) {
    for (const Json& key : schema.value("required", Json::array())) {
      if (!object.contains(key.get<std::string>())) add(fmt::format("the key {} is missing", shown(key)));
    }
    const Json properties = schema.value("properties", Json::object());
    for (const auto& [key, value] : object.items()) {
      if (properties.contains(key)) {
        visit_part(properties[key], value, key);
      } else if (schema.contains("additionalProperties") && schema["additionalProperties"] == false) {
        add_unknown(key, keys_of(properties), schema.value("title", ""));
      }
    }
  }

  /// Adds an unknown key. A document, whose schema has a title, may be of another kind if no known key is near.
  void add_unknown(const std::string& key, const std::vector<std::string>& known, const std::string& title) {
    const bool other_kind = !title.empty() && !nearest_word(key, known);
    const std::string kind = other_kind ? fmt::format(" in a {}", title) : "";
    add(fmt::format("unknown key \"{}\"{}{}", printable(key, 60), kind, suggestion(key, known)));
    findings_.back().priority = other_kind ? 2000 : 1000;
  }

  /// Returns the keys for messages, without "$schema", which editors use.
  static std::vector<std::string> keys_of(const Json& properties) {
    std::vector<std::string> keys;
    for (const auto& property : properties.items()) {
      if (!property.key().starts_with('$')) keys.push_back(property.key());
    }
    return keys;
  }

  void check_conditions(const Json& schema, const Json& value) {
    for (const Json& conjunct : schema.value("allOf", Json::array())) visit(conjunct, value);
    if (schema.contains("not") && meets(value, schema["not"])) {
      add(fmt::format("is not allowed: {} (found {})", schema.value("description", "another value is needed"),
                      shown(value)));
    }
    if (!schema.contains("if")) return;
    const char* branch = meets(value, schema["if"]) ? "then" : "else";
    if (schema.contains(branch)) visit(schema[branch], value);
  }

  const Json* root_;
  std::vector<std::string> path_;
  std::vector<Finding> findings_;
};

bool is_valid(const Json& rules, const Json& configuration) {
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7)
      .populateSchema(valijson::adapters::NlohmannJsonAdapter(rules), schema);
  valijson::Validator validator;
  return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(configuration), nullptr);
}

/// Returns the weight of a finding, the most informative the largest. A misspelt key explains a missing one, and a
/// document of another kind explains everything.
std::size_t weight(const Finding& finding) { return finding.priority + finding.path.size(); }

}  // namespace

void check_by_schema(const Json& document, const nlohmann::ordered_json& schema, const std::string& source) {
  const Json rules{{"allOf", Json::array({Json(schema)})}, {"definitions", schema_definitions()}};
  if (is_valid(rules, document)) return;
  SchemaWalk walk(rules);
  walk.visit(rules, document);
  const auto worst = std::ranges::max_element(walk.findings(), {}, weight);
  if (worst == walk.findings().end()) {
    throw InputError(fmt::format("{}: does not match the schema of an experiment", source));
  }
  const std::string location = worst->path.empty() ? "" : fmt::format("{}: ", fmt::join(worst->path, "."));
  throw InputError(fmt::format("{}: {}{}", source, printable(location, 200), printable(worst->message, 500)));
}

void check_against_schema(const Json& part, const std::string& definition, const std::string& source) {
  check_by_schema(part, nlohmann::ordered_json{{"$ref", "#/definitions/" + definition}}, source);
}

}  // namespace shapegauge

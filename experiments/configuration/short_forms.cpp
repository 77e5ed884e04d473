// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/short_forms.h"

#include <nlohmann/json.hpp>

namespace shapegauge {

namespace {

using Json = nlohmann::json;

/// Replaces a name by an object that has it at the key.
void expand_name(Json& value, const char* key) {
  if (value.is_string()) value = Json::object({{key, value}});
}

void expand_field(Json& field, const Json& defaults) {
  expand_name(field, "type");
  for (const auto& [key, value] : defaults.items()) {
    if (field.is_object()) field.emplace(key, value);  // unless it is there
  }
}

/// Returns the list at a key of an object; null if there is none.
Json* array_at(Json& object, const char* key) {
  return object.is_object() && object.contains(key) && object[key].is_array() ? &object[key] : nullptr;
}

void expand_signature(Json& signature, const Json& defaults) {
  if (!signature.is_object()) return;
  if (signature.contains("field")) expand_field(signature["field"], defaults);
  if (Json* const terms = array_at(signature, "sum")) {
    for (Json& term : *terms) expand_name(term, "of");
  }
  if (!signature.contains("descriptor")) return;
  expand_name(signature["descriptor"], "type");
  if (Json* const fields = array_at(signature["descriptor"], "fields")) {
    for (Json& field : *fields) expand_field(field, defaults);
  }
}

}  // namespace

void expand_short_forms(Json& document) {
  Json* const signatures = array_at(document, "signatures");
  if (signatures == nullptr) return;
  const Json defaults = document.value("defaults", Json::object());
  if (!defaults.is_object()) return;
  for (Json& signature : *signatures) expand_signature(signature, defaults);
  document.erase("defaults");
}

}  // namespace shapegauge

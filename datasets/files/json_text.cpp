// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/json_text.h"

#include <nlohmann/json.hpp>

#include "shapegauge/core/base/utf8.h"

namespace shapegauge {

namespace {

template <typename Json>
Json escaped(const Json& value) {
  if (value.is_string()) return with_escaped_bytes(value.template get_ref<const std::string&>());
  if (!value.is_structured()) return value;
  Json result = value.is_array() ? Json::array() : Json::object();
  for (const auto& [name, member] : value.items()) {
    if (value.is_array()) {
      result.push_back(escaped(member));
    } else {
      result[with_escaped_bytes(name)] = escaped(member);
    }
  }
  return result;
}

template <typename Json>
std::string text_of_json(const Json& value, int indent) {
  try {
    return value.dump(indent);
  } catch (const typename Json::type_error&) {  // text that is not UTF-8
    return escaped(value).dump(indent);
  }
}

}  // namespace

nlohmann::json escaped_json(const nlohmann::json& value) { return escaped(value); }
nlohmann::ordered_json escaped_json(const nlohmann::ordered_json& value) { return escaped(value); }

std::string json_text(const nlohmann::json& value, int indent) { return text_of_json(value, indent); }
std::string json_text(const nlohmann::ordered_json& value, int indent) { return text_of_json(value, indent); }

}  // namespace shapegauge

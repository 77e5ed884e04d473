#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "shapegauge/experiments/fields/field.h"

namespace shapegauge {

/// A kind of field that configurations can name.
struct FieldType {
  std::string_view name;
  /// The field of the given settings, which the schema has accepted. Throws InputError where they contradict each
  /// other.
  Field (*make)(const nlohmann::json& settings);
};

/// All kinds of fields. A new one is one file in this folder, one line in field_registry.cpp, and the description of
/// its settings in configs/experiment.schema.json.
std::span<const FieldType> field_types();

/// The field that the settings describe, by their "type". Throws InputError for a type that is not in field_types().
Field make_field(const nlohmann::json& settings);

}  // namespace shapegauge

#pragma once

#include <nlohmann/json.hpp>

#include "shapegauge/core/fields/field.h"

namespace shapegauge {

/// The setting "at" of fields: "faces" (default), "vertices" or {"surface": number of samples}.
SamplePlan sample_plan_of(const nlohmann::json& settings);

/// The setting that the plan was read from.
nlohmann::json to_json(const SamplePlan& plan);

/// The field that the settings of a configuration describe: "type", the settings of that type, "at" and "bilateral".
/// Throws InputError for a type that is not in field_types(), and for settings that the type does not take.
Field read_field(const nlohmann::json& settings);

/// The settings in that form, defaults filled in.
nlohmann::json to_json(const FieldSettings& settings);

}  // namespace shapegauge

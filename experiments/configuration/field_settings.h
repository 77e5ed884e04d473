// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "shapegauge/core/fields/field.h"

namespace shapegauge {

/// Parses the setting "at" of fields: "faces" (default), "vertices" or {"surface": number of samples}.
SamplePlan sample_plan_of(const nlohmann::json& settings);

/// Formats a sample plan as the setting "at".
nlohmann::json to_json(const SamplePlan& plan);

/// Makes the field with the given settings: "type", the settings of that type, "at" and "bilateral". Throws InputError
/// for a type that is not in field_types(), and for invalid settings.
Field read_field(const nlohmann::json& settings);

/// Formats a field's settings in that form, with all defaults.
nlohmann::json to_json(const FieldSettings& settings);

}  // namespace shapegauge

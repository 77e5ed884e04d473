// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "shapegauge/core/fields/field.h"

namespace shapegauge {

/// Reads the setting "at" of a field, the locations of its samples: "faces" (default), "vertices" or {"surface": number
/// of samples}.
SamplePlan sample_plan_of(const nlohmann::json& settings);

/// Formats a sample plan as the setting "at" of a field.
nlohmann::json to_json(const SamplePlan& plan);

/// Makes a field from its settings: "type", the parameters of the type, "at" (sample locations) and "bilateral"
/// (smoothing). Throws InputError for a type that is not in field_types(), and for invalid settings.
Field read_field(const nlohmann::json& settings);

/// Formats the settings of a field as read_field() reads them, with all defaults.
nlohmann::json to_json(const FieldSettings& settings);

}  // namespace shapegauge

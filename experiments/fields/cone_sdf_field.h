#pragma once

#include <nlohmann/json.hpp>

#include "shapegauge/experiments/fields/field.h"

namespace shapegauge {

/// The field type "cone_sdf": settings `engine`, `opening_angle_degrees`, `rays`, `postprocess` and `at` of cone_sdf
/// (the design, section 2.3). Throws InputError where the engine cannot do what is asked.
Field cone_sdf_field(const nlohmann::json& settings);

}  // namespace shapegauge

#pragma once

#include <nlohmann/json.hpp>

#include "shapegauge/experiments/fields/field.h"

namespace shapegauge {

/// The field type "offset_sdf": settings `offset`, a fraction of the diagonal or "auto" (automatic_offset), and `at`
/// of offset_sdf (the design, section 2.2).
Field offset_sdf_field(const nlohmann::json& settings);

}  // namespace shapegauge

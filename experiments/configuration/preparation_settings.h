#pragma once

#include <nlohmann/json.hpp>

#include "shapegauge/core/preparation/prepare_shape.h"

namespace shapegauge {

/// The options of a configuration's "preparation", which the schema has accepted.
PreparationOptions read_preparation(const nlohmann::json& settings);

/// The options in that form.
nlohmann::json to_json(const PreparationOptions& preparation);

}  // namespace shapegauge

#pragma once

#include <string_view>

namespace shapegauge {

/// The JSON Schema (draft 7) of an experiment's configuration: the text of configs/experiment.schema.json.
std::string_view experiment_schema();

}  // namespace shapegauge

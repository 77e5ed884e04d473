#pragma once

#include <nlohmann/json_fwd.hpp>

#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// Encodes an evaluation as a cache record.
nlohmann::json to_record(const Evaluation& evaluation);

/// Decodes the record, bit by bit. Throws nlohmann::json::exception for a malformed record.
Evaluation evaluation_from_record(const nlohmann::json& record);

}  // namespace shapegauge

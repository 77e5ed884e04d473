#pragma once

#include <nlohmann/json_fwd.hpp>

#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// The evaluation as an entry of the cache.
nlohmann::json to_record(const Evaluation& evaluation);

/// Reads the record back, bit by bit. Throws nlohmann::json::exception where it is not of that form.
Evaluation evaluation_from_record(const nlohmann::json& record);

}  // namespace shapegauge

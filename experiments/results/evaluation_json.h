#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// An evaluation as JSON (the design, section 6): protocol, ties, number of queries, models that are never queries, and
/// the measures as fractions: micro, macro, and per class by the class's name.
nlohmann::ordered_json evaluation_json(const Evaluation& evaluation, std::span<const std::string> class_names);

}  // namespace shapegauge

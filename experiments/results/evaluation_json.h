#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// An evaluation as JSON (the design, section 6): protocol, ties, number of queries, of those that ties could change,
/// and of models that are never queries; the measures as fractions: micro, macro, and per class by the class's name;
/// and where there are intervals those of the averages.
nlohmann::ordered_json evaluation_json(const Evaluation& evaluation, std::span<const std::string> class_names,
                                       const EvaluationIntervals& intervals = {});

}  // namespace shapegauge

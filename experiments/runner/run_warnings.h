#pragma once

#include <string>
#include <vector>

#include "shapegauge/experiments/runner/run_experiment.h"

namespace shapegauge {

/// Sentences about the results of a run that its user should know: field_warnings(), and for each method with tied
/// queries (relevant and other models at equal distance) how many there are, and between which bounds the order of the
/// tied models moves FT.
std::vector<std::string> run_warnings(const ExperimentResults& results);

}  // namespace shapegauge

#pragma once

#include <string>
#include <vector>

#include "shapegauge/experiments/runner/run_experiment.h"

namespace shapegauge {

/// Warnings about the results of a run: field_warnings(), and for each method with tied queries (relevant and other
/// models at equal distance) their number and the range of FT over the orders of tied models.
std::vector<std::string> run_warnings(const ExperimentResults& results);

}  // namespace shapegauge

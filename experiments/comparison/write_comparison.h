#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/experiments/comparison/run_comparison.h"
#include "shapegauge/experiments/engine/experiment.h"

namespace shapegauge {

/// The entry of the registry (experiment_kinds()).
ExperimentKind comparison_kind();

/// Writes all result files of a comparison into the folder, as write_results() does.
void write_comparison(const std::filesystem::path& destination, const ComparisonResults& results);

/// The summary of a comparison for a terminal: distances, errors, normals, timings.
std::string summary_text(const ComparisonResults& results);

}  // namespace shapegauge

#pragma once

#include <filesystem>

#include "shapegauge/experiments/runner/run_experiment.h"

namespace shapegauge {

/// Writes all result files (the design, section 5) into the folder, made where absent, each whole or not at all, the
/// manifest last; then removes what an earlier run wrote and this one has not. Throws InputError where a file cannot be
/// written: the folder then holds what it held before (StagedResults).
void write_results(const std::filesystem::path& destination, const ExperimentResults& results);

/// The results' summary for a terminal.
std::string summary_text(const ExperimentResults& results);

}  // namespace shapegauge

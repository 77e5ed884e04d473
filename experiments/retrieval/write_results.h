#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/retrieval/run_experiment.h"

namespace shapegauge {

/// Makes a retrieval experiment. Distances are written by rows; whole matrices are in memory only as run_experiment()
/// documents.
Experiment retrieval_experiment(Configuration configuration);

/// Returns the entry for experiment_kinds().
ExperimentKind retrieval_kind();

/// Writes all result files of a run (docs/reference/definitions.md#result-files) into the folder, created if missing,
/// each atomically, the manifest last; then removes files of an earlier run that this one did not write. Throws
/// InputError if a file cannot be written; the folder is then unchanged (StagedResults).
void write_results(const std::filesystem::path& destination, const ExperimentResults& results);

/// Formats the summary of a run for a terminal: its evaluations.
std::string summary_text(const ExperimentResults& results);

}  // namespace shapegauge

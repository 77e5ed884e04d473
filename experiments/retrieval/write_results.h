#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/retrieval/run_experiment.h"

namespace shapegauge {

/// A retrieval experiment. The distances go to their files by rows: whole matrices are in memory only where
/// run_experiment() says so.
Experiment retrieval_experiment(Configuration configuration);

/// The entry of the registry (experiment_kinds()).
ExperimentKind retrieval_kind();

/// Writes all result files of a run (docs/reference/definitions.md#result-files) into the folder, made where absent,
/// each whole or not at all, the manifest last; then removes what an earlier run wrote and this one has not. Throws
/// InputError where a file cannot be written: the folder then holds what it held before (StagedResults).
void write_results(const std::filesystem::path& destination, const ExperimentResults& results);

/// The summary of a run for a terminal: its evaluations.
std::string summary_text(const ExperimentResults& results);

}  // namespace shapegauge

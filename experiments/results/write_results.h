#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/experiments/runner/run_comparison.h"
#include "shapegauge/experiments/runner/run_experiment.h"

namespace shapegauge {

/// Writes all result files of a run (docs/definitions.md#result-files) into the folder, made where absent, each whole
/// or not at all, the manifest last; then removes what an earlier run wrote and this one has not. Throws InputError
/// where a file cannot be written: the folder then holds what it held before (StagedResults).
/// @{
void write_results(const std::filesystem::path& destination, const ExperimentResults& results);
void write_comparison(const std::filesystem::path& destination, const ComparisonResults& results);
/// @}

/// Runs an experiment and writes its results into the folder as write_results() does. The distances go to their files
/// by rows: whole matrices are in memory only where run_experiment() says so, and not in what is returned. Of several
/// processes rank 0 has the folder, and the results. Collective. Throws as run_experiment() and write_results().
ExperimentResults run_into_folder(const std::filesystem::path& destination, const Configuration& configuration,
                                  const RunControl& control, Cache& cache, Communicator& ranks);

/// The summary of a run for a terminal: the evaluations of an experiment; distances, errors, normals and timings of a
/// comparison.
/// @{
std::string summary_text(const ExperimentResults& results);
std::string summary_text(const ComparisonResults& results);
/// @}

}  // namespace shapegauge

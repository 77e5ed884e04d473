#pragma once

#include <filesystem>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/results/experiment_results.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

/// Runs a whole experiment: data set, signatures, distances, evaluation. Writes nothing but a data set that the
/// configuration asks to generate, which goes to (or is found in) the folder. Throws InputError for a model that fails
/// with OnError::stop, for data that cannot be evaluated, and Interrupted. Results are the same bytes whatever the
/// cache holds.
ExperimentResults run_experiment(const Configuration& configuration, const std::filesystem::path& generated_folder,
                                 const RunControl& control, Cache& cache);

/// The same without a cache.
ExperimentResults run_experiment(const Configuration& configuration, const std::filesystem::path& generated_folder,
                                 const RunControl& control);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/retrieval/experiment_results.h"

namespace shapegauge {

/// Runs a whole experiment: data set, signatures, distances and evaluation (run_methods.h). `distance_files` has a
/// `.npy` file by signature, to which its distances are written by rows; if empty, the results contain the distances
/// that the configuration keeps. Throws InputError for a model that fails with
/// OnError::stop and for data that cannot be evaluated; throws Interrupted. Results are the same bytes whatever the
/// state of the cache, for any number of threads.
ExperimentResults run_experiment(const Configuration& configuration, const RunContext& context,
                                 const std::vector<std::filesystem::path>& distance_files);

/// Runs an experiment without a cache and with the matrices in the results.
ExperimentResults run_experiment(const Configuration& configuration, const std::filesystem::path& generated_folder,
                                 const RunControl& control);

/// Describes a part of the models through the cache. Then, if the cache has the descriptions of all models, evaluates a
/// part of the rows of distances that run_methods() streams, and stores the scores. Throws as run_experiment() does.
PartOutcome run_part_of_experiment(const Configuration& configuration, const RunContext& context, const Part& part);

}  // namespace shapegauge

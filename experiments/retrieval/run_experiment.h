// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/retrieval/experiment_results.h"

namespace shapegauge {

/// Runs a whole retrieval experiment: reads the data set, computes signatures and distances, and evaluates these
/// (run_methods.h). `distance_files` has a `.npy` path for each signature, to which the distances are written by rows;
/// if empty, the results contain the distances that the configuration keeps. Results are the same bytes whatever the
/// state of the cache, for any number of threads. Throws InputError for a model that fails with OnError::stop and for
/// data that cannot be evaluated; throws Interrupted.
ExperimentResults run_experiment(const Configuration& configuration, const RunContext& context,
                                 const std::vector<std::filesystem::path>& distance_files);

/// Runs a retrieval experiment without a cache. The results contain the distance matrices that the configuration keeps.
/// A generated data set is written to `generated_folder`.
ExperimentResults run_experiment(const Configuration& configuration, const std::filesystem::path& generated_folder,
                                 const RunControl& control);

/// Describes one part (engine/part.h) of the models and stores the descriptions (ModelDescription) in the cache, for
/// runs on several machines. If the cache then has the descriptions of all models, also evaluates a part of the rows of
/// distances that run_methods() streams, and stores the scores. Throws as run_experiment() does.
PartOutcome run_part_of_experiment(const Configuration& configuration, const RunContext& context, const Part& part);

}  // namespace shapegauge

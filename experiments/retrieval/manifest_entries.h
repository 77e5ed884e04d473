// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "shapegauge/experiments/retrieval/experiment_results.h"

namespace shapegauge {

/// Returns the manifest entries of a retrieval experiment besides the program, the configuration and the files: seed,
/// SHA-256 of every input, models, failures, outcomes of samples.
nlohmann::ordered_json manifest_entries(const ExperimentResults& results);

/// Returns the inputs of a run on a data set on disk as its manifest would record them, without models whose file
/// cannot be read. Runs in the calling TBB arena.
nlohmann::ordered_json dataset_inputs(const Configuration& configuration, const std::vector<Model>& models);

}  // namespace shapegauge

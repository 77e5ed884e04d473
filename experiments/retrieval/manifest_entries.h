// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "shapegauge/experiments/retrieval/experiment_results.h"

namespace shapegauge {

/// Returns the JSON values of a retrieval experiment in the manifest, besides the program, the configuration and the
/// result files: seed, SHA-256 of every input file, models, failures, numbers of samples by outcome.
nlohmann::ordered_json manifest_entries(const ExperimentResults& results);

/// Returns the JSON value "inputs" of a manifest, the SHA-256 of each input file of a data set on disk, before a run.
/// Omits models whose file cannot be read. Runs in the calling TBB arena.
nlohmann::ordered_json dataset_inputs(const Configuration& configuration, const std::vector<Model>& models);

}  // namespace shapegauge

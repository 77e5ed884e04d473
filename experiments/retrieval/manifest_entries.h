#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "shapegauge/experiments/retrieval/run_experiment.h"

namespace shapegauge {

/// What the manifest of a retrieval experiment says besides the program, the configuration and the files: seed, SHA-256
/// of every input, models, failures, outcomes of samples.
nlohmann::ordered_json manifest_entries(const ExperimentResults& results);

/// Its "execution": threads, processes, timings, and how many results of each kind came from the cache.
nlohmann::ordered_json execution_entries(const ExperimentResults& results);

/// The inputs of a run of a data set on disk as its manifest would record them. Models whose file cannot be read are
/// left out. Runs in the calling TBB arena.
nlohmann::ordered_json dataset_inputs(const Configuration& configuration, const std::vector<Model>& models);

}  // namespace shapegauge

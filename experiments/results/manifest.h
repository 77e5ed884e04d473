#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/experiments/results/experiment_results.h"

namespace shapegauge {

/// What a run was, to know and to repeat it: version, commit, compiler, libraries, configuration with all defaults
/// filled in, SHA-256 of every input, outcomes of samples, failed models, threads, timings, and the files of its
/// results. Everything but "execution" (threads, timings, use of the cache) is the same whatever the number of threads
/// and whatever came from the cache.
///
/// `files`, in the folder, are written already: their SHA-256 is in the manifest, but for tables of timings.
nlohmann::ordered_json manifest(const ExperimentResults& results, const std::vector<std::string>& files,
                                const std::filesystem::path& folder);

/// The inputs of a run of a data set on disk as its manifest would record them. Models whose file cannot be read are
/// left out. Runs in the calling TBB arena.
nlohmann::ordered_json dataset_inputs(const Configuration& configuration, const std::vector<Model>& models);

}  // namespace shapegauge

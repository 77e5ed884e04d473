#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/experiments/results/experiment_results.h"

namespace shapegauge {

/// What a run was, to know and to repeat it: version, commit, compiler, libraries, configuration with all defaults
/// filled in, SHA-256 of every input, outcomes of samples, failed models, threads, timings, and the files of its
/// results. Everything but "execution" (threads and timings) is the same whatever the number of threads.
nlohmann::ordered_json manifest(const ExperimentResults& results, const std::vector<std::string>& files);

}  // namespace shapegauge

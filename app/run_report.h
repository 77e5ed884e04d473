#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/engine/experiment.h"

/// What `shapegauge run` prints of a run and of its replay.
namespace shapegauge {

/// Warns on standard error of inputs of a run that are not those recorded, at most ten by name.
void warn_of_changed_inputs(const std::vector<std::string>& changes);

/// Prints for each output of a repeated run whether it is the same bytes as recorded, and what else differs: inputs,
/// program. Returns the exit status: 1 where an output differs.
int report_replay(const nlohmann::json& recorded, const std::filesystem::path& results);

/// What a run took from the cache, as a line: "From the cache: 600 of 600 fields, ..."; empty where that is nothing.
std::string cache_text(const CacheReport& cache);

/// Prints the notes, the warnings and the shapes left out; returns the exit status.
int report_flaws(const RunOutcome& outcome);

}  // namespace shapegauge

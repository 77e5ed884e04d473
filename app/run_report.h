// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/engine/experiment.h"

/// Output of `shapegauge run` about a run and its replay.
namespace shapegauge {

/// Prints one warning per input file that differs from that of the recorded run, at most ten. `changes` has one text
/// per such file.
void warn_of_changed_inputs(const std::vector<std::string>& changes);

/// Prints for each output file of a repeated run in the folder `results` whether its bytes equal those of the recorded
/// run, and the changes of inputs and program. `recorded` is the manifest of the recorded run. Returns the exit status
/// of the program: 1 if an output differs.
int report_replay(const nlohmann::json& recorded, const std::filesystem::path& results);

/// Formats the use of the cache by a run as a line: "From the cache: 600 of 600 fields, ..."; empty if the cache
/// provided no results.
std::string cache_text(const CacheReport& cache);

/// Prints the notes and warnings of a run and its omitted shapes; returns the exit status of the program.
int report_run_problems(const RunOutcome& outcome);

}  // namespace shapegauge

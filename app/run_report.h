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

/// Prints warnings about inputs that differ from the recorded ones, one text per input in `changes`; at most ten.
void warn_of_changed_inputs(const std::vector<std::string>& changes);

/// Prints for each output of a repeated run whether its bytes match the record, and names the changes of inputs and
/// program. Returns the exit status: 1 if an output differs.
int report_replay(const nlohmann::json& recorded, const std::filesystem::path& results);

/// Formats the use of the cache by a run as a line: "From the cache: 600 of 600 fields, ..."; empty if nothing was
/// used.
std::string cache_text(const CacheReport& cache);

/// Prints the notes and warnings of a run and its omitted shapes; returns the exit status of the program.
int report_flaws(const RunOutcome& outcome);

}  // namespace shapegauge

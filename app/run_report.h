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

/// Warns on standard error of inputs that differ from those recorded; lists at most ten.
void warn_of_changed_inputs(const std::vector<std::string>& changes);

/// Prints for each output of a repeated run whether its bytes match the record, and which inputs and program differ.
/// Returns the exit status: 1 if an output differs.
int report_replay(const nlohmann::json& recorded, const std::filesystem::path& results);

/// Formats the use of the cache as a line: "From the cache: 600 of 600 fields, ..."; empty if nothing was used.
std::string cache_text(const CacheReport& cache);

/// Prints the notes, the warnings and the omitted shapes; returns the exit status.
int report_flaws(const RunOutcome& outcome);

}  // namespace shapegauge

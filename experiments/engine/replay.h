// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "shapegauge/experiments/configuration/document_paths.h"

namespace shapegauge {

/// Reads the manifest of a run. Throws InputError if the file cannot be read or does not suffice to repeat the run.
nlohmann::json read_manifest(const std::filesystem::path& path);

/// Returns the configuration in a manifest, to run it again. A `root` that is not empty replaces the folder of its data
/// set, and the common folder of its other files; `paths_of` returns their places. A classification below the old
/// folder moves along. Throws InputError if the run has no files or several data sets.
nlohmann::json recorded_configuration(const nlohmann::json& manifest, const std::filesystem::path& root,
                                      const PathsOfDocument& paths_of);

/// Lists the differences between inputs (as "inputs" of a manifest) and those that the manifest of a run records, a
/// line each: changed, absent, new. Kinds of inputs that were not recorded at all are not compared. Unrecorded files of
/// models that failed in that run are counted in one line.
std::vector<std::string> changed_inputs(const nlohmann::json& manifest, const nlohmann::json& now);

/// Lists the differences between the running program and the recorded one, a line each: version, commit, libraries,
/// processor.
std::vector<std::string> changed_program(const nlohmann::json& manifest);

/// Comparison of the outputs of a repeated run with the recorded ones.
struct ComparedOutputs {
  std::vector<std::string> same;
  std::vector<std::string> different;  ///< different bytes, or missing now
  std::vector<std::string> timings;    ///< not compared, because they vary between runs
};

/// Compares the outputs recorded in two manifests.
ComparedOutputs compare_outputs(const nlohmann::json& recorded, const nlohmann::json& now);

}  // namespace shapegauge

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

/// Returns the configuration in a manifest, to repeat the run. A `root` that is not empty replaces the folder of the
/// run's data set and the common folder of its other input files; the path of a classification in that folder changes
/// with it. `paths_of` returns the positions of paths in the configuration. Throws InputError if there is a `root` and
/// the run has no files or several data sets.
nlohmann::json recorded_configuration(const nlohmann::json& manifest, const std::filesystem::path& root,
                                      const PathsOfDocument& paths_of);

/// Lists the differences between the present inputs `now` (in the form of "inputs" of a manifest) and those recorded in
/// the manifest of a run, one line each: a file is changed, absent or new. Kinds of inputs that were not recorded at
/// all are not compared. Unrecorded files of models that failed in the recorded run are counted in one line.
std::vector<std::string> changed_inputs(const nlohmann::json& manifest, const nlohmann::json& now);

/// Lists the differences between the running program and the one recorded in a manifest, one line each: version,
/// commit, libraries, processor.
std::vector<std::string> changed_program(const nlohmann::json& manifest);

/// Comparison of the outputs of a repeated run with the recorded ones.
struct ComparedOutputs {
  std::vector<std::string> same;       ///< names of result files with the recorded bytes
  std::vector<std::string> different;  ///< names of result files with other bytes, or that are now missing
  std::vector<std::string> timings;    ///< names of result files with run times, which are not compared
};

/// Compares the SHA-256 of result files in the manifest of the first run, `recorded`, with those in the manifest of the
/// repeated run, `now`.
ComparedOutputs compare_outputs(const nlohmann::json& recorded, const nlohmann::json& now);

}  // namespace shapegauge

#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace shapegauge {

/// Reads the manifest of a run. Throws InputError if the file cannot be read or does not suffice to repeat the run.
nlohmann::json read_manifest(const std::filesystem::path& path);

/// Returns the configuration in a manifest, to run it again. A `root` that is not empty replaces the data set's folder,
/// for its classification and, in a comparison, for shape files below it. Throws InputError if the run has no data set
/// of files.
nlohmann::json recorded_configuration(const nlohmann::json& manifest, const std::filesystem::path& root);

/// Lists the differences between inputs ("inputs" of the manifest) and those recorded, a line each: changed, absent,
/// new.
std::vector<std::string> changed_inputs(const nlohmann::json& recorded, const nlohmann::json& now);

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

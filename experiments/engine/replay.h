#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace shapegauge {

/// The manifest of a run. Throws InputError where the file cannot be read or does not say how to repeat the run.
nlohmann::json read_manifest(const std::filesystem::path& path);

/// The configuration in a manifest, to be run again. With a `root` that is not empty, the data set is looked for there:
/// its classification and, of a comparison, the files of its shapes where they lay below the folder then. Throws
/// InputError where the run has no data set of files.
nlohmann::json recorded_configuration(const nlohmann::json& manifest, const std::filesystem::path& root);

/// How the inputs of a run ("inputs" of its manifest) differ from those recorded, a line each: changed, absent, new.
std::vector<std::string> changed_inputs(const nlohmann::json& recorded, const nlohmann::json& now);

/// How the running program differs from the recorded one, a line each: version, commit, libraries, processor.
std::vector<std::string> changed_program(const nlohmann::json& manifest);

/// The outputs of a repeated run beside the recorded ones.
struct ComparedOutputs {
  std::vector<std::string> same;
  std::vector<std::string> different;  ///< other bytes, or absent now
  std::vector<std::string> timings;    ///< not compared, for they differ from run to run
};

/// Compares the outputs that two manifests record.
ComparedOutputs compare_outputs(const nlohmann::json& recorded, const nlohmann::json& now);

}  // namespace shapegauge

#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace shapegauge {

/// What is to be run: a configuration, or a recorded run.
struct RunSource {
  std::filesystem::path configuration;
  std::vector<std::string> overrides;  ///< of the configuration, see apply_override
  std::filesystem::path replay;        ///< the manifest of the run to repeat, instead of a configuration
  std::filesystem::path dataset_root;  ///< with replay: where the data set is here; empty: where it was then
};

/// An experiment to be run: what its configuration says, and whence.
// NOLINTNEXTLINE(bugprone-exception-escape): JSON moves without exceptions, which the check does not see
struct RequestedRun {
  nlohmann::json document;
  std::string source;            ///< what messages call it
  std::filesystem::path folder;  ///< that paths are relative to
  nlohmann::json recorded;       ///< the manifest of the run that this one repeats; null for a new one
};

/// Reads what is to be run. Throws InputError where it cannot be read or contradicts itself.
RequestedRun requested_run(const RunSource& source);

}  // namespace shapegauge

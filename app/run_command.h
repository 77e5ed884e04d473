#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/progress_line.h"
#include "shapegauge/experiments/cache/cache.h"

namespace CLI {
class App;
}

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

/// Warns on standard error of inputs of a run that are not those recorded, at most ten by name.
void warn_of_changed_inputs(const std::vector<std::string>& changes);

/// Says on standard output, once a recorded run was repeated, for each of its outputs whether it is the same bytes, and
/// what else is not as recorded: inputs, program. Returns the exit status: 1 where an output differs.
int report_replay(const nlohmann::json& recorded, const std::filesystem::path& results);

/// A line that says what a run took from the cache, "From the cache: 600 of 600 fields, ..."; empty where that is
/// nothing.
std::string cache_text(const CacheReport& cache);

/// At the end of its scope, however a run ends, it says on standard error what the cache could not do.
class CacheWarnings {
 public:
  CacheWarnings(const Cache& cache, ProgressLine& progress) : cache_(&cache), progress_(&progress) {}
  CacheWarnings(const CacheWarnings&) = delete;
  CacheWarnings& operator=(const CacheWarnings&) = delete;
  CacheWarnings(CacheWarnings&&) = delete;
  CacheWarnings& operator=(CacheWarnings&&) = delete;
  ~CacheWarnings();

 private:
  const Cache* cache_;
  ProgressLine* progress_;
};

/// Adds the command for an experiment from its configuration: `shapegauge run`. It runs while the arguments are parsed
/// and leaves its exit status in `status`, which must outlive the app.
void add_run_command(CLI::App& app, int& status);

}  // namespace shapegauge

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/distributed/communicator.h"
#include "shapegauge/experiments/engine/run_control.h"

namespace shapegauge {

/// What a run has besides its configuration.
struct RunContext {
  const RunControl& control;
  Cache& cache;
  Communicator& ranks;
  std::filesystem::path generated;  ///< folder for a data set that the program makes; it outlives the run
  std::filesystem::path results;    ///< folder to write result files into; the same for all ranks
};

/// What a run has done. Of several processes rank 0 knows it.
struct RunOutcome {
  std::vector<std::string> files = {};    ///< written to RunContext::results, by name; without the manifest
  nlohmann::ordered_json manifest = {};   ///< seed, inputs, counts, failures, fields: what the manifest says of them
  nlohmann::ordered_json execution = {};  ///< threads, seconds, use of the cache: what differs from run to run
  std::string summary = {};               ///< for a terminal
  std::vector<std::string> notes = {};    ///< what users should know of the files
  std::vector<std::string> warnings = {};
  std::vector<LeftOutShape> left_out = {};
  std::size_t used = 0;             ///< shapes that the results are of
  std::string_view noun = "model";  ///< what one of them is called
  CacheReport cache = {};
};

/// An experiment: a configuration that was read and checked, and how it is run.
struct Experiment {
  std::string name;
  nlohmann::json configuration;                 ///< all defaults filled in
  std::optional<DatasetLocation> dataset = {};  ///< what it reads, where that is one data set on disk
  /// The inputs as the manifest of a run would record them, read by so many threads (0: all); null: they are known
  /// after the run only.
  std::function<nlohmann::json(int threads)> inputs = {};
  /// Collective. Throws InputError for data that cannot be used, and Interrupted.
  std::function<RunOutcome(const RunContext&)> run;
};

/// A kind of experiment that configurations can ask for.
struct ExperimentKind {
  std::string_view name;
  std::string_view description;  ///< one sentence
  /// Whether the document of a configuration is of this kind.
  bool (*describes)(const nlohmann::json& document) = nullptr;
  /// Reads the document. `source` is what messages call it; relative paths are relative to `folder`. Throws InputError
  /// with the source, the path to the value, what is wrong and the nearest valid word.
  Experiment (*read)(const nlohmann::json& document, const std::string& source,
                     const std::filesystem::path& folder) = nullptr;
};

/// The manifest of a run whose result files lie in the folder: all there is to know of it and to repeat it. Program
/// (program_json()), configuration, what the kind of experiment adds, SHA-256 of the result files. Nothing in it but
/// "execution" depends on the number of threads or on the cache.
nlohmann::ordered_json manifest_of(const nlohmann::json& configuration, const RunOutcome& outcome,
                                   const std::filesystem::path& folder);

/// Puts results into a folder: calls `write` with a folder of their own inside it, where it is to write all files but
/// the manifest; then writes that and moves all of them to their places (StagedResults).
void publish_results(const std::filesystem::path& destination, const nlohmann::json& configuration,
                     const std::function<RunOutcome(const std::filesystem::path& folder)>& write);

/// Runs an experiment, and puts its results into a folder that is made where absent and locked meanwhile. Collective;
/// rank 0 has the folder and the outcome. An earlier run's results are replaced when all are complete, those of another
/// configuration only with `replace`. Afterwards the cache is trimmed. Throws InputError for a folder that cannot be
/// used, for ranks with different configurations, and what the experiment throws.
RunOutcome run_into_folder(const Experiment& experiment, const std::filesystem::path& destination, bool replace,
                           const RunControl& control, Cache& cache, Communicator& ranks);

}  // namespace shapegauge

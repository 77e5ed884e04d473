// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/document_paths.h"
#include "shapegauge/experiments/engine/part.h"
#include "shapegauge/experiments/engine/run_control.h"

namespace shapegauge {

/// Environment of a run.
struct RunContext {
  const RunControl& control;
  Cache& cache;
  std::filesystem::path generated = {};  ///< folder for a generated data set; it outlives the run
};

/// Where a run writes its results.
struct RunResults {
  std::filesystem::path folder;       ///< for result files
  nlohmann::ordered_json& manifest;   ///< receives entries for the manifest: seed, inputs, counts, failures, fields
  nlohmann::ordered_json& execution;  ///< receives entries that vary between runs: threads, seconds, use of the cache
};

/// Outcome of a run.
struct RunOutcome {
  std::vector<std::string> files = {};  ///< names of files written to RunResults::folder, without the manifest
  std::string summary = {};             ///< for a terminal
  std::vector<std::string> notes = {};  ///< remarks on the files for users
  std::vector<std::string> warnings = {};
  std::vector<LeftOutShape> left_out = {};
  std::vector<std::string> incomplete = {};  ///< parts of the results without some of the shapes, a sentence each
  std::size_t used = 0;                      ///< number of shapes that the results cover
  std::string_view noun = "model";           ///< noun for a shape
  CacheReport cache = {};
};

/// Outcome of a part of a run, whose results are in the cache.
struct PartOutcome {
  std::size_t shapes = 0;  ///< number of shapes of the part
  std::size_t all = 0;     ///< number of shapes of the run
  std::vector<LeftOutShape> left_out = {};
  std::string_view noun = "model";
  std::size_t rows = 0;  ///< rows of distance matrices that the part has evaluated
};

/// Validated configuration of an experiment with the function that runs it.
struct Experiment {
  std::string name;
  std::function<nlohmann::json()> configuration;        ///< formats the configuration with all defaults
  std::vector<std::filesystem::path> input_paths = {};  ///< folders and files that results must not overwrite
  std::vector<std::string> result_folders = {};         ///< subfolders of the results that have a manifest of their own
  /// Reads the inputs with that many threads (0: all) as the manifest would record them; null if they are known only
  /// after the run.
  std::function<nlohmann::json(int threads)> inputs = {};
  /// Runs the experiment. Throws InputError for unusable data, and Interrupted.
  std::function<RunOutcome(const RunContext&, const RunResults&)> run;
  /// Computes a part of what the run needs and stores it in the cache. Throws as run() does. Null if the kind of
  /// experiment has no parts.
  std::function<PartOutcome(const RunContext&, const Part&)> run_part = {};
};

/// Kind of experiment: how its documents are recognised, validated and run.
struct ExperimentKind {
  std::string_view name;
  std::string_view description;        ///< one sentence
  std::vector<std::string> keys = {};  ///< a document with all of these at its root is of this kind
  DocumentPaths paths = {};            ///< relative paths in the document
  /// Returns the JSON Schema of the document, which may refer to schema_definitions(). A schema cannot have definitions
  /// of its own.
  nlohmann::ordered_json (*schema)() = nullptr;
  /// Reads a document. Those of read_experiment() have been validated by the schema; the library's kinds validate
  /// others themselves. `source` is its name in messages; relative paths are relative to `folder`. Throws InputError
  /// with the source, the path to the value, the fault and the nearest valid word.
  Experiment (*read)(const nlohmann::json& document, const std::string& source,
                     const std::filesystem::path& folder) = nullptr;
};

/// Makes the manifest of a run with these result files, which documents the run and suffices to repeat it:
/// program (program_json()), configuration, entries of the kind of experiment, SHA-256 of the result files. Only
/// "execution" depends on the number of threads and the cache.
nlohmann::ordered_json manifest_of(const Experiment& experiment, const RunResults& results,
                                   const std::vector<std::string>& files);

/// Runs an experiment and publishes its results in a folder, which is created if missing and locked meanwhile.
/// Results of an earlier run are replaced when the new ones are complete, those of another configuration only with
/// `replace`. Finally trims the cache. Throws InputError for an unusable folder and for results that would overwrite an
/// input, and the errors of the experiment.
RunOutcome run_into_folder(const Experiment& experiment, const std::filesystem::path& destination, bool replace,
                           const RunControl& control, Cache& cache);

/// Computes a part of an experiment with results in the folder, which only receives a generated data set. Any number of
/// processes may do so at the same time, also with the same part. The cache is not trimmed. Throws InputError for an
/// experiment without parts and for a disabled cache, and the errors of the experiment.
PartOutcome run_part(const Experiment& experiment, const Part& part, const std::filesystem::path& destination,
                     const RunControl& control, Cache& cache);

}  // namespace shapegauge

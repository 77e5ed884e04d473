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

/// Execution environment of a run: threads and cancellation, cache, and folder for generated data.
struct RunContext {
  const RunControl& control;             ///< number of threads, cancellation and progress
  Cache& cache;                          ///< store of results; may be disabled
  std::filesystem::path generated = {};  ///< folder for a generated data set, kept after the run; unused without one
};

/// Destinations of the results of a run: the folder of result files and entries of the manifest.
struct RunResults {
  std::filesystem::path folder;       ///< folder that receives the result files
  nlohmann::ordered_json& manifest;   ///< receives entries of manifest.json: seed, inputs, failures, fields
  nlohmann::ordered_json& execution;  ///< receives entries that vary between runs: threads, seconds, use of the cache
};

/// Outcome of a run: names of its files, messages for users, and omitted shapes.
struct RunOutcome {
  std::vector<std::string> files = {};       ///< names of files written to RunResults::folder, without the manifest
  std::string summary = {};                  ///< summary of the results, for a terminal
  std::vector<std::string> notes = {};       ///< remarks on the result files for users
  std::vector<std::string> warnings = {};    ///< warnings about the data and the results, one sentence each
  std::vector<LeftOutShape> left_out = {};   ///< shapes that the run omitted
  std::vector<std::string> incomplete = {};  ///< sentences, one per method that could not process all shapes
  std::size_t used = 0;                      ///< number of shapes that the results include
  std::string_view noun = "model";           ///< noun for a shape in messages, such as "model"
  CacheReport cache = {};                    ///< numbers of results found in the cache and computed
};

/// Outcome of one part (Part) of a distributed run, whose results are in the cache.
struct PartOutcome {
  std::size_t shapes = 0;                   ///< number of shapes of this part whose results are now in the cache
  std::size_t all = 0;                      ///< number of shapes of the whole run
  std::vector<LeftOutShape> left_out = {};  ///< shapes that the part omitted
  std::string_view noun = "model";          ///< noun for a shape in messages, such as "model"
  std::size_t rows = 0;                     ///< number of rows of distance matrices that this part has evaluated
};

/// Validated configuration of an experiment with the function that runs it.
struct Experiment {
  std::string name;                                     ///< name of the experiment, for messages and result folders
  std::function<nlohmann::json()> configuration;        ///< returns the configuration as JSON, with all defaults
  std::vector<std::filesystem::path> input_paths = {};  ///< input folders and files, which results must not overwrite
  std::vector<std::string> result_folders = {};         ///< subfolders of the results that have a manifest of their own
  /// Reads the input files and returns the value of "inputs" in the manifest. `threads` is the number of threads; 0 for
  /// all cores. Null if the input files are known only after the run.
  std::function<nlohmann::json(int threads)> inputs = {};
  /// Runs the experiment. Throws InputError for unusable data, and Interrupted.
  std::function<RunOutcome(const RunContext&, const RunResults&)> run;
  /// Computes one part of the results that the run needs and stores it in the cache. Throws as `run` does. Null if the
  /// experiment cannot be divided into parts.
  std::function<PartOutcome(const RunContext&, const Part&)> run_part = {};
};

/// Kind of experiment: how its documents are recognised, validated and run.
struct ExperimentKind {
  std::string_view name;               ///< name of the kind, such as "retrieval" or "segmentation"
  std::string_view description;        ///< description in one sentence
  std::vector<std::string> keys = {};  ///< a document is of this kind if it has all these keys at its root
  DocumentPaths paths = {};            ///< positions of relative paths in the document
  /// Returns the JSON Schema of configurations of this kind, which may refer to schema_definitions(). A schema cannot
  /// have definitions of its own.
  nlohmann::ordered_json (*schema)() = nullptr;
  /// Reads an experiment from a document. read_experiment() has validated its documents by the schema; the library's
  /// kinds also accept other documents and validate them. `source` is the document's name in messages; relative paths
  /// are relative to `folder`. Throws InputError with the source, the path to the value, the fault and the most similar
  /// valid word.
  Experiment (*read)(const nlohmann::json& document, const std::string& source,
                     const std::filesystem::path& folder) = nullptr;
};

/// Makes the manifest of a run from the JSON in `results` and the SHA-256 of the result files `files`. The manifest
/// suffices to repeat the run: program (program_json()), configuration, inputs, hashes of results. Only its value
/// "execution" depends on the number of threads and the cache.
nlohmann::ordered_json manifest_of(const Experiment& experiment, const RunResults& results,
                                   const std::vector<std::string>& files);

/// Runs an experiment and publishes its results in a folder, which is created if missing and locked during the run.
/// Results of an earlier run are replaced when the new ones are complete; those of another configuration only if
/// `replace` is set. Finally trims the cache. Throws InputError for an unusable folder and for results that would
/// overwrite an input, and the errors of the experiment.
RunOutcome run_into_folder(const Experiment& experiment, const std::filesystem::path& destination, bool replace,
                           const RunControl& control, Cache& cache);

/// Computes one part of a distributed run and stores its results in the cache. The folder of the run only receives a
/// generated data set. Any number of processes may compute parts at the same time, also the same part. The cache is not
/// trimmed. Throws InputError for an experiment without parts and for a disabled cache, and the errors of the
/// experiment.
PartOutcome run_part(const Experiment& experiment, const Part& part, const std::filesystem::path& destination,
                     const RunControl& control, Cache& cache);

}  // namespace shapegauge

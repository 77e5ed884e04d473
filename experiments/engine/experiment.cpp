// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/engine/experiment.h"

#include <cstdint>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/experiments/cache/cache_folder.h"
#include "shapegauge/experiments/engine/manifest.h"
#include "shapegauge/experiments/engine/result_folder.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

/// Returns the names of the main results, which are known before the run.
std::vector<std::string> main_results(const Experiment& experiment) {
  std::vector<std::string> folders{""};
  for (const std::string& part : experiment.result_folders) folders.push_back(part + "/");
  std::vector<std::string> files;
  for (const std::string& folder : folders) {
    files.push_back(fmt::format("{}{}", folder, manifest_name));
    files.push_back(folder + "summary.json");
  }
  return files;
}

/// Writes the manifest and publishes all files. Throws InputError if one would overwrite an input.
void publish(StagedResults& staged, const fs::path& destination, const Experiment& experiment,
             const RunResults& results, const std::vector<std::string>& files) {
  check_results_are_no_inputs(destination, files, experiment.input_paths);
  write_file_atomically(results.folder / manifest_name, json_text(manifest_of(experiment, results, files), 2) + "\n");
  staged.publish(files);
}

}  // namespace

nlohmann::ordered_json manifest_of(const Experiment& experiment, const RunResults& results,
                                   const std::vector<std::string>& files) {
  nlohmann::ordered_json json = program_json();
  json["configuration"] = experiment.configuration();
  json.update(results.manifest);
  json.update({{"files", files}, {"outputs", outputs_json(results.folder, files)}, {"execution", results.execution}});
  return json;
}

RunOutcome run_into_folder(const Experiment& experiment, const fs::path& destination, bool replace,
                           const RunControl& control, Cache& cache) {
  const std::uintmax_t limit = cache_limit();  // reports a wrong setting before the run
  check_results_are_no_inputs(destination, main_results(experiment), experiment.input_paths);
  const FolderLock lock(destination);
  prepare_result_folder(destination, experiment.configuration(), replace);
  StagedResults staged(destination);
  nlohmann::ordered_json manifest = nlohmann::ordered_json::object();
  nlohmann::ordered_json execution;
  const RunResults results{.folder = fs::absolute(staged.folder()), .manifest = manifest, .execution = execution};
  RunOutcome outcome =
      experiment.run({.control = control, .cache = cache, .generated = destination / "dataset"}, results);
  with_threads(control.threads, [&] { publish(staged, destination, experiment, results, outcome.files); });
  if (!cache.folder().empty()) trim_cache(cache.folder(), limit);
  return outcome;
}

PartOutcome run_part(const Experiment& experiment, const Part& part, const fs::path& destination,
                     const RunControl& control, Cache& cache) {
  if (!experiment.run_part) throw InputError("experiments of this kind cannot be divided into parts; omit `part`");
  if (cache.folder().empty()) throw InputError("`part` needs a folder that all parts share as `cache`");
  require_writable(cache.folder());
  return experiment.run_part({.control = control, .cache = cache, .generated = destination / "dataset"}, part);
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/engine/replay.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/engine/manifest.h"
#include "shapegauge/experiments/engine/result_folder.h"

namespace shapegauge {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Pointer = Json::json_pointer;

namespace {

/// Returns the hashes of inputs by name.
std::map<std::string, std::string> named_inputs(const Json& inputs) {
  std::map<std::string, std::string> named;
  for (const auto& [kind, word] : {std::pair{"models", "model"}, std::pair{"shapes", "shape"}}) {
    if (!inputs.contains(kind)) continue;
    for (const auto& [name, hash] : inputs.at(kind).items()) named[fmt::format("{} {}", word, name)] = hash;
  }
  if (inputs.contains("classification")) named["the classification"] = inputs.at("classification");
  return named;
}

/// Returns the model among those that failed in the recorded run to which the named input belongs; empty if none.
std::string failed_model(const Json& manifest, const std::string& input) {
  for (const Json& failed : manifest.value("failed_models", Json::array())) {
    std::string name = "model " + failed.value("model", "");
    if (input == name || input.starts_with(name + "/")) return name;
  }
  return "";
}

/// Returns true if the path is the folder or below it.
bool lies_in(const fs::path& path, const fs::path& folder) {
  const fs::path relative = path.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

/// Moves a path from below the old root to the new one; returns other paths unchanged.
fs::path moved_to_root(const fs::path& path, const fs::path& old_root, const fs::path& root) {
  return lies_in(path, old_root) ? (root / path.lexically_relative(old_root)).lexically_normal() : path;
}

/// Returns the path at a pointer into the recorded configuration. Throws InputError for anything but text.
fs::path path_at(const Json& configuration, const Pointer& pointer) {
  const Json& path = configuration.at(pointer);
  if (path.is_string()) return path.get<std::string>();
  throw InputError(
      fmt::format("configuration.{} of the manifest: expected a path; the manifest is damaged", dotted(pointer)));
}

/// Returns the deepest folder that contains all files at the pointers; empty if there are none.
fs::path common_folder(const Json& configuration, const std::vector<Pointer>& files) {
  std::optional<fs::path> common;
  for (const Pointer& file : files) {
    const fs::path folder = path_at(configuration, file).parent_path();
    if (!common) common = folder;
    while (!lies_in(folder, *common)) common = common->parent_path();
  }
  return common.value_or(fs::path());
}

void move_files(Json& configuration, const std::vector<Pointer>& files, const fs::path& root) {
  const fs::path old_root = common_folder(configuration, files);
  for (const Pointer& file : files) {
    configuration[file] = moved_to_root(path_at(configuration, file), old_root, root).string();
  }
}

void move_dataset(Json& configuration, const Pointer& dataset, const fs::path& root) {
  const fs::path old_root = path_at(configuration, dataset / "root");
  configuration[dataset / "root"] = root.string();
  const Pointer classification = dataset / "classification";
  if (!configuration.contains(classification)) return;
  configuration[classification] = moved_to_root(path_at(configuration, classification), old_root, root).string();
}

/// Returns true for an object of hashes by name.
bool has_hashes(const Json& value) {
  return value.is_object() && std::ranges::all_of(value, [](const Json& hash) { return hash.is_string(); });
}

bool is_failure(const Json& value) { return value.is_object() && value.value("model", Json("")).is_string(); }

/// Throws InputError for entries that changed_inputs() and compare_outputs() cannot read.
void check_entries(const Json& manifest, const std::string& source) {
  const auto expect = [&](const char* entry, bool valid, const char* expected) {
    if (!valid) throw InputError(fmt::format("{}: {}: expected {}; the manifest is damaged", source, entry, expected));
  };
  const Json& inputs = manifest.at("inputs");
  expect("inputs.models", has_hashes(inputs.value("models", Json::object())), "the hash of each model");
  expect("inputs.shapes", has_hashes(inputs.value("shapes", Json::object())), "the hash of each shape");
  expect("inputs.classification", inputs.value("classification", Json("")).is_string(), "a hash");
  expect("outputs.files", has_hashes(manifest.at("outputs").value("files", Json())), "the hash of each file");
  const Json failed = manifest.value("failed_models", Json::array());
  expect("failed_models", failed.is_array() && std::ranges::all_of(failed, is_failure), "the name of each model");
}

}  // namespace

Json read_manifest(const fs::path& path) {
  Json manifest = read_json(path);
  for (const char* key : {"configuration", "inputs", "outputs"}) {
    if (!manifest.is_object() || !manifest.contains(key) || !manifest.at(key).is_object()) {
      throw InputError(
          fmt::format("{}: missing \"{}\"; expected the manifest of a run of this version ({} among its results)",
                      path.string(), key, manifest_name));
    }
  }
  check_entries(manifest, path.string());
  return manifest;
}

Json recorded_configuration(const Json& manifest, const fs::path& root, const PathsOfDocument& paths_of) {
  Json configuration = manifest.at("configuration");
  if (root.empty()) return configuration;
  const fs::path absolute_root = fs::absolute(root).lexically_normal();
  const DocumentPaths paths = paths_of(configuration);
  const std::vector<Pointer> files = matching_pointers(configuration, paths.files);
  std::vector<Pointer> datasets = matching_pointers(configuration, paths.datasets);
  std::erase_if(datasets, [&](const Pointer& pointer) { return !configuration.at(pointer).contains("root"); });
  if (datasets.size() > 1) {
    throw InputError(fmt::format("`dataset_root`: the run has several data sets; name each, as in `set={}.root=FOLDER`",
                                 dotted(datasets.front())));
  }
  if (datasets.empty() && files.empty()) {
    throw InputError("`dataset_root`: all shapes of this run were generated; omit it");
  }
  for (const Pointer& dataset : datasets) move_dataset(configuration, dataset, absolute_root);
  move_files(configuration, files, absolute_root);
  return configuration;
}

std::vector<std::string> changed_inputs(const Json& manifest, const Json& now) {
  const Json& recorded = manifest.at("inputs");
  const std::map<std::string, std::string> before = named_inputs(recorded);
  Json recorded_kinds = Json::object();  // earlier versions recorded no classification of a segmentation
  const Json names = escaped_json(now);  // as in manifests
  for (const auto& [kind, hashes] : names.items()) {
    if (recorded.contains(kind)) recorded_kinds[kind] = hashes;
  }
  const std::map<std::string, std::string> after = named_inputs(recorded_kinds);
  std::vector<std::string> changes;
  for (const auto& [name, hash] : before) {
    const auto found = after.find(name);
    if (found == after.end()) {
      changes.push_back(name + " is absent");
    } else if (found->second != hash) {
      changes.push_back(name + " differs from the recorded one");
    }
  }
  std::set<std::string> failed;  // earlier versions recorded no files of shapes that a segmentation could not use
  for (const auto& [name, hash] : after) {
    if (before.contains(name)) continue;
    if (const std::string model = failed_model(manifest, name); !model.empty()) {
      failed.insert(model);
    } else {
      changes.push_back(name + " was not recorded");
    }
  }
  if (!failed.empty()) {
    changes.push_back(fmt::format("the files of {} that failed in the recorded run were not recorded",
                                  count_text(std::ssize(failed), "model", "models")));
  }
  return changes;
}

std::vector<std::string> changed_program(const Json& manifest) {
  std::vector<std::string> changes;
  const Json here = program_json();
  for (const auto& [key, value] : here.items()) {
    const Json recorded = manifest.value(key, Json("unknown"));
    if (recorded != value)
      changes.push_back(fmt::format("{}: {}, recorded was {}", key, value.dump(), recorded.dump()));
  }
  return changes;
}

ComparedOutputs compare_outputs(const Json& recorded, const Json& now) {
  ComparedOutputs compared;
  const Json files_now = now.at("outputs").at("files");
  for (const auto& [name, hash] : recorded.at("outputs").at("files").items()) {
    (files_now.value(name, "") == hash.get<std::string>() ? compared.same : compared.different).push_back(name);
  }
  for (const Json& file : now.at("files")) {
    if (holds_timings(file.get<std::string>())) compared.timings.push_back(file);
  }
  return compared;
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/configuration/dataset_files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/base/error.h"
#include "shapegauge/experiments/configuration/document_paths.h"
#include "shapegauge/experiments/configuration/json_document.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

nlohmann::json dataset_in_file(const fs::path& path) {
  nlohmann::json dataset = read_json(path);
  if (!dataset.is_object() || !(dataset.contains("layout") || dataset.contains("generate"))) {
    throw InputError(fmt::format("{}: describes no data set: expected an object with layout and root", path.string()));
  }
  if (!dataset.contains("name")) dataset["name"] = path.stem().string();
  for (const char* key : {"$schema", "description"}) dataset.erase(key);
  if (!dataset.contains("root") || !dataset["root"].is_string()) return dataset;
  const auto root = dataset["root"].get<std::string>();
  // Variables are expanded later, and may contain absolute paths.
  if (root.find("${") == std::string::npos) {
    dataset["root"] = fs::absolute(path.parent_path() / root).lexically_normal().string();
  }
  return dataset;
}

}  // namespace

std::vector<fs::path> read_dataset_files(nlohmann::json& document, const std::string& source, const fs::path& folder,
                                         const std::vector<std::string>& datasets) {
  std::vector<fs::path> files;
  for (const nlohmann::json::json_pointer& pointer : matching_pointers(document, datasets)) {
    nlohmann::json& dataset = document.at(pointer);
    if (!dataset.is_string()) continue;
    try {
      files.push_back(folder / expand_variables(dataset.get<std::string>()));
      dataset = dataset_in_file(files.back());
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}: {}", source, dotted(pointer), error.what()));
    }
    if (!document.at(pointer.parent_pointer()).is_array()) dataset.erase("name");
  }
  return files;
}

}  // namespace shapegauge

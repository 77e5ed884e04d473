#include "shapegauge/experiments/configuration/dataset_files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "shapegauge/core/base/error.h"
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

void read_dataset_files(nlohmann::json& document, const std::string& source, const fs::path& folder) {
  if (!document.is_object()) return;
  const auto described = [&](const nlohmann::json& file, std::string_view place) {
    try {
      return dataset_in_file(folder / expand_variables(file.get<std::string>()));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}: {}", source, place, error.what()));
    }
  };
  if (document.contains("dataset") && document["dataset"].is_string()) {
    document["dataset"] = described(document["dataset"], "dataset");
    document["dataset"].erase("name");
  }
  if (!document.contains("datasets") || !document["datasets"].is_array()) return;
  for (nlohmann::json& dataset : document["datasets"]) {
    if (dataset.is_string()) dataset = described(dataset, "datasets");
  }
}

}  // namespace shapegauge

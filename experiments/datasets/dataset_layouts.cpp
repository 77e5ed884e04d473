#include "shapegauge/experiments/datasets/dataset_layouts.h"

#include <array>
#include <fmt/format.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/read_shape.h"
#include "shapegauge/experiments/datasets/csv_layout.h"
#include "shapegauge/experiments/datasets/folders_layout.h"
#include "shapegauge/experiments/datasets/shrec11_layout.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

void require_folder(const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return;
  throw InputError(fmt::format("{}: {}; give the folder that holds the data set", folder.string(),
                               fs::exists(folder, ignored) ? "is not a folder" : "no such folder"));
}

}  // namespace

std::span<const DatasetLayout> dataset_layouts() {
  static constexpr std::array layouts{
      DatasetLayout{"shrec11", find_shrec11_dataset, "test.cla"},
      DatasetLayout{"folders", find_folders_dataset, ""},
      DatasetLayout{"csv", find_csv_dataset, "models.csv"},
  };
  return layouts;
}

const DatasetLayout& dataset_layout(std::string_view name) {
  for (const DatasetLayout& layout : dataset_layouts()) {
    if (layout.name == name) return layout;
  }
  throw InputError(fmt::format("there is no data set layout \"{}\"", name));
}

Dataset find_dataset(const DatasetLocation& location) {
  require_folder(location.root);
  Dataset dataset = dataset_layout(location.layout).find(location);
  if (dataset.models.empty()) {
    throw InputError(fmt::format("{}: no models (OFF, OBJ, PLY, STL, XYZ, PWN or PTS) in the layout \"{}\"",
                                 location.root.string(), location.layout));
  }
  return dataset;
}

DatasetLocation recognise_dataset(const fs::path& root, const fs::path& classification) {
  require_folder(root);
  if (!classification.empty()) {
    const bool table = classification.extension() == ".csv";
    return {.layout = table ? "csv" : "shrec11", .root = root, .classification = classification};
  }
  for (const DatasetLayout& layout : dataset_layouts()) {
    const fs::path usual = root / layout.usual_classification;
    if (!layout.usual_classification.empty() && fs::exists(usual)) {
      return {.layout = std::string(layout.name), .root = root, .classification = usual};
    }
  }
  return {.layout = "folders", .root = root, .classification = {}};
}

std::vector<ModelFailure> check_models(const Dataset& dataset) {
  std::vector<ModelFailure> failures;
  for (std::size_t i = 0; i < dataset.models.size(); ++i) {
    try {
      check_shape_header(dataset.models[i].file);
    } catch (const InputError& error) {
      failures.push_back({.model = i, .message = error.what()});
    }
  }
  return failures;
}

}  // namespace shapegauge

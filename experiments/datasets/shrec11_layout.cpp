#include "shapegauge/experiments/datasets/shrec11_layout.h"

#include <fmt/format.h>
#include <map>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/datasets/classification_file.h"
#include "shapegauge/experiments/datasets/model_files.h"
#include "shapegauge/experiments/datasets/model_ids.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

/// The models' files by canonical id.
std::map<std::string, fs::path> files_by_id(const fs::path& folder) {
  std::map<std::string, fs::path> files;
  for (const fs::path& file : model_files(folder)) {
    const auto [earlier, added] = files.emplace(canonical_model_id(file.filename().string()), file);
    if (!added) {
      throw InputError(fmt::format("{}: {} and {} are both the model {}; keep one", folder.string(),
                                   earlier->second.filename().string(), file.filename().string(), earlier->first));
    }
  }
  return files;
}

}  // namespace

Dataset find_shrec11_dataset(const DatasetLocation& location) {
  const Classification classification = read_classification(location.classification);
  const std::vector<std::string> ids = models_in_natural_order(classification);
  const std::vector<int> labels = class_labels(classification, ids, location.classification.string());
  const std::map<std::string, fs::path> files = files_by_id(location.root);

  Dataset dataset;
  for (const ModelClass& model_class : classification.classes) dataset.classes.push_back(model_class.name);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::string id = canonical_model_id(ids[i]);
    const auto file = files.find(id);
    const fs::path expected = location.root / fmt::format("T{}.off", id);
    dataset.models.push_back({.id = ids[i], .file = file == files.end() ? expected : file->second, .label = labels[i]});
  }
  return dataset;
}

}  // namespace shapegauge

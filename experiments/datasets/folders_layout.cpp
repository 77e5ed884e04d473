#include "shapegauge/experiments/datasets/folders_layout.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/datasets/model_files.h"
#include "shapegauge/experiments/datasets/natural_order.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

void append(std::vector<fs::path>& files, const fs::path& folder) {
  const std::vector<fs::path> more = model_files(folder);
  files.insert(files.end(), more.begin(), more.end());
}

/// The files of a class: those of the split, and with "all" also those right in the class's folder.
std::vector<fs::path> class_files(const fs::path& folder, const std::string& split) {
  std::vector<fs::path> files;
  if (split == "all") append(files, folder);
  for (const char* part : {"test", "train"}) {
    if ((split == "all" || split == part) && fs::is_directory(folder / part)) append(files, folder / part);
  }
  return files;
}

}  // namespace

Dataset find_folders_dataset(const DatasetLocation& location) {
  Dataset dataset;
  std::set<std::string> ids;
  for (const fs::path& folder : subfolders(location.root)) {
    const std::vector<fs::path> files = class_files(folder, location.split);
    if (files.empty()) {
      throw InputError(
          fmt::format("{}: no models (OFF, OBJ, PLY, STL, XYZ, PWN or PTS) in this class{}", folder.string(),
                      location.split == "all" ? "" : fmt::format(" for the split \"{}\"", location.split)));
    }
    const int label = static_cast<int>(dataset.classes.size());
    dataset.classes.push_back(folder.filename().string());
    for (const fs::path& file : files) {
      const std::string id = fs::path(file).replace_extension().lexically_relative(location.root).generic_string();
      if (!ids.insert(id).second) {
        throw InputError(fmt::format("{}: another file is the model {} already; keep one", file.string(), id));
      }
      dataset.models.push_back({.id = id, .file = file, .label = label});
    }
  }
  if (dataset.classes.empty()) {
    throw InputError(
        fmt::format("{}: the layout \"folders\" needs a folder for each class, there is none", location.root.string()));
  }
  std::ranges::sort(dataset.models, natural_less, &Model::id);
  return dataset;
}

}  // namespace shapegauge

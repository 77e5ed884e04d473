#include "shapegauge/experiments/datasets/dataset.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/experiments/files/model_ids.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

template <typename Predicate>
std::vector<fs::path> entries(const fs::path& folder, Predicate wanted) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (wanted(entry)) found.push_back(entry.path());
  }
  std::ranges::sort(found, natural_less, [](const fs::path& path) { return path.filename().string(); });
  return found;
}

}  // namespace

bool is_model_file(const fs::path& path) {
  const std::string name = path.filename().string();
  return !is_hidden(path) && without_shape_extension(name) != name;
}

std::vector<fs::path> model_files(const fs::path& folder) {
  return entries(
      folder, [](const fs::directory_entry& entry) { return entry.is_regular_file() && is_model_file(entry.path()); });
}

std::vector<fs::path> subfolders(const fs::path& folder) {
  return entries(folder,
                 [](const fs::directory_entry& entry) { return entry.is_directory() && !is_hidden(entry.path()); });
}

}  // namespace shapegauge

#include "shapegauge/datasets/layouts/dataset.h"

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <system_error>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/datasets/files/model_ids.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

template <typename Predicate>
std::vector<fs::path> entries(const fs::path& folder, Predicate wanted) {
  std::vector<fs::path> found;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
       entry.increment(failure)) {
    if (!is_hidden(entry->path()) && wanted(entry->path())) found.push_back(entry->path());
  }
  if (failure) throw InputError(fmt::format("cannot read {}: {}", folder.string(), failure.message()));
  std::ranges::sort(found, natural_less, [](const fs::path& path) { return path.filename().string(); });
  return found;
}

}  // namespace

bool is_model_file(const fs::path& path) {
  const std::string name = path.filename().string();
  return !is_hidden(path) && without_shape_extension(name) != name;
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool leads_nowhere(const fs::path& path) {
  std::error_code ignored;
  return fs::is_symlink(path, ignored) && !fs::exists(path, ignored);
}

std::vector<fs::path> model_files(const fs::path& folder) { return entries(folder, is_model_file); }

std::vector<fs::path> subfolders(const fs::path& folder) {
  return entries(folder, [](const fs::path& path) {
    return is_folder(path) || (leads_nowhere(path) && path.extension().empty());
  });
}

}  // namespace shapegauge

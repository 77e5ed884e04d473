// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/layouts/dataset.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string_view>
#include <system_error>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/datasets/files/model_ids.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

}  // namespace

int label_of_class(const std::string& name, Dataset& dataset) {
  const auto found = std::ranges::find(dataset.classes, name);
  const auto label = static_cast<int>(found - dataset.classes.begin());
  if (found == dataset.classes.end()) dataset.classes.push_back(name);
  return label;
}

void add_model(Model model, std::set<std::string>& ids, Dataset& dataset) {
  if (!ids.insert(model.id).second) {
    throw InputError(
        fmt::format("{}: another file has the same model id, {}; keep one", model.file.string(), model.id));
  }
  dataset.models.push_back(std::move(model));
}

bool is_model_file(const fs::path& path) {
  const std::string name = path.filename().string();
  return !is_hidden(path) && without_shape_extension(name) != name;
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool is_readable_folder(const fs::path& path) {
  std::error_code failure;
  const fs::directory_iterator entries(path, failure);
  return !failure;
}

bool is_broken_link(const fs::path& path) {
  std::error_code ignored;
  return fs::is_symlink(path, ignored) && !fs::exists(path, ignored);
}

bool is_cyclic_link(const fs::path& path) {
  std::error_code failure;
  static_cast<void>(fs::status(path, failure));
  return failure == std::errc::too_many_symbolic_link_levels;
}

fs::path canonical_or_same(const fs::path& path) {
  std::error_code failure;
  fs::path canonical = fs::canonical(path, failure);
  return failure ? path : canonical;
}

std::string skipped_text(const SkippedEntries& skipped) {
  std::vector<std::string> parts;
  const auto add = [&](std::size_t count, std::string_view one, std::string_view several) {
    if (count > 0) parts.push_back(count_text(static_cast<std::int64_t>(count), one, several));
  };
  add(skipped.files, "file that is not a shape", "files that are not shapes");
  add(skipped.shapes, "shape outside of the layout", "shapes outside of the layout");
  add(skipped.folders, "folder", "folders");
  return parts.empty() ? "" : fmt::format("skipped: {}", fmt::join(parts, ", "));
}

std::vector<fs::path> visible_entries(const fs::path& folder, const std::function<bool(const fs::path&)>& condition) {
  std::vector<fs::path> found;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
       entry.increment(failure)) {
    if (!is_hidden(entry->path()) && condition(entry->path())) found.push_back(entry->path());
  }
  if (failure) throw InputError(fmt::format("cannot read {}: {}", folder.string(), failure.message()));
  std::ranges::sort(found, natural_less, [](const fs::path& path) { return path.filename().string(); });
  return found;
}

SkippedEntries skipped_entries(const fs::path& root, const std::vector<Model>& models) {
  std::set<fs::path> files;
  std::set<fs::path> holders{root};
  for (const Model& model : models) {
    files.insert(model.file);
    for (fs::path folder = model.file.parent_path(); holders.insert(folder).second;) folder = folder.parent_path();
  }
  SkippedEntries skipped;
  std::vector<fs::path> waiting{root};
  while (!waiting.empty()) {
    const fs::path folder = waiting.back();
    waiting.pop_back();
    for (const fs::path& entry : visible_entries(folder, [&](const fs::path& path) { return !files.contains(path); })) {
      if (!is_folder(entry)) {
        ++(is_model_file(entry) ? skipped.shapes : skipped.files);
      } else if (holders.contains(entry)) {
        waiting.push_back(entry);
      } else {
        ++skipped.folders;
      }
    }
  }
  return skipped;
}

std::vector<fs::path> model_files(const fs::path& folder) { return visible_entries(folder, is_model_file); }

std::vector<fs::path> subfolders(const fs::path& folder) {
  return visible_entries(folder, [](const fs::path& path) {
    return is_folder(path) || (is_broken_link(path) && path.extension().empty());
  });
}

std::set<fs::path> visited_at_root(const fs::path& root) {
  std::set<fs::path> visited;
  for (fs::path folder = canonical_or_same(root); visited.insert(folder).second;) folder = folder.parent_path();
  return visited;
}

std::vector<fs::path> unvisited(std::vector<fs::path> folders, std::set<fs::path>& visited) {
  std::set<fs::path> repeated;
  for (const bool links : {false, true}) {
    for (const fs::path& path : folders) {
      std::error_code ignored;
      if (fs::is_symlink(path, ignored) != links) continue;
      if (!visited.insert(canonical_or_same(path)).second) repeated.insert(path);
    }
  }
  std::erase_if(folders, [&](const fs::path& path) { return repeated.contains(path); });
  return folders;
}

}  // namespace shapegauge

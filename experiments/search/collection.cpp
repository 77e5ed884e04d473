// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/search/collection.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/model_ids.h"
#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/configuration/dataset_files.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/configuration/schema.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

/// Returns the path relative to the folder if it is below it, otherwise absolute.
fs::path relative_to(const fs::path& folder, const fs::path& path) {
  const fs::path relative =
      fs::absolute(path).lexically_normal().lexically_relative(fs::absolute(folder).lexically_normal());
  const bool below = !relative.empty() && *relative.begin() != "..";
  return below ? relative : fs::absolute(path).lexically_normal();
}

void add_files_below(const fs::path& folder, std::set<fs::path>& visited, std::vector<fs::path>& links,
                     Collection& collection);

/// Collects the shapes in a folder and below unless it has been visited or cannot be read.
void visit_folder(const fs::path& folder, std::set<fs::path>& visited, std::vector<fs::path>& links,
                  Collection& collection) {
  std::error_code failure;
  if (is_readable_folder(folder) && visited.insert(fs::canonical(folder, failure)).second) {
    add_files_below(folder, visited, links, collection);
  } else {
    ++collection.skipped.folders;
  }
}

/// Collects the shapes in a folder and below, except beyond links to folders, which are added to `links`.
void add_files_below(const fs::path& folder, std::set<fs::path>& visited, std::vector<fs::path>& links,
                     Collection& collection) {
  std::vector<fs::path> paths;
  std::error_code failure;
  const fs::directory_iterator entries(folder, failure);
  if (!failure) std::ranges::copy(entries, std::back_inserter(paths));
  if (failure) throw InputError(fmt::format("cannot read {}: {}", folder.string(), failure.message()));
  std::ranges::sort(paths);
  for (const fs::path& path : paths) {
    const bool hidden = path.filename().string().starts_with('.');
    if (!is_folder(path)) {
      if (is_model_file(path)) {
        const fs::path relative = path.lexically_relative(collection.base);
        collection.files.push_back({.id = relative.generic_string(), .path = relative});
      } else if (!hidden) {
        ++collection.skipped.files;
      }
    } else if (!hidden && fs::is_symlink(path, failure)) {
      links.push_back(path);
    } else if (!hidden) {
      visit_folder(path, visited, links, collection);
    }
  }
}

/// Collects the shapes in a folder and below. A folder that links lead to is visited once, by its own name if possible.
Collection files_below(const fs::path& folder) {
  Collection collection{.base = folder, .files = {}};
  std::set<fs::path> visited = visited_at_root(folder);
  std::vector<fs::path> links;
  add_files_below(folder, visited, links, collection);
  while (!links.empty()) {
    for (const fs::path& link : std::exchange(links, {})) visit_folder(link, visited, links, collection);
  }
  return collection;
}

Collection files_of_list(const fs::path& list) {
  Collection collection{.base = list.parent_path(), .files = {}};
  const std::string text = read_file_bytes(list);
  for (const std::string_view line : split_lines(text)) {
    const std::string path(trim(line));
    if (path.empty() || path.starts_with('#')) continue;
    collection.files.push_back({.id = path, .path = path});
  }
  return collection;
}

Collection files_of_dataset(const DatasetLocation& location) {
  Collection collection{.base = location.root, .files = {}};
  const Dataset dataset = find_dataset(location);
  collection.skipped = dataset.skipped;
  for (const Model& model : dataset.models) {
    collection.files.push_back({.id = model.id, .path = relative_to(location.root, model.file)});
  }
  return collection;
}

/// Validates and reads the "dataset" of a configuration.
DatasetLocation location_in(const fs::path& configuration) {
  const std::string source = configuration.string();
  nlohmann::json document = read_json(configuration);
  read_dataset_files(document, source, configuration.parent_path(), retrieval_paths().datasets);
  if (!document.is_object() || !document.contains("dataset") || document["dataset"].contains("generate")) {
    throw InputError(fmt::format("{}: a collection needs a configuration with a \"dataset\" of files on disk", source));
  }
  check_by_schema(document, {{"properties", {{"dataset", {{"$ref", "#/definitions/dataset"}}}}}}, source);
  return with_source(source, [&] {
    return at_key("dataset", [&] { return read_location(document["dataset"], configuration.parent_path()); });
  });
}

Collection files_named_by(const fs::path& path) {
  const std::string extension = lower_case(path.extension().string());
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (extension == ".txt" || extension == ".lst") return files_of_list(path);
  if (extension == ".cla") {
    return files_of_dataset({.layout = "shrec11", .root = folder, .classification = path});
  }
  if (is_model_table(path)) return files_of_dataset({.layout = "csv", .root = folder, .classification = path});
  if (extension == ".json") return files_of_dataset(location_in(path));
  throw InputError(fmt::format(
      "{} is not a collection; the last argument must be a folder, a list of files (.txt), or a data set (.cla, .csv, "
      ".json)",
      path.string()));
}

}  // namespace

Collection find_collection(const fs::path& path) {
  std::error_code failure;
  if (!fs::exists(path, failure)) {
    throw InputError(
        fmt::format("cannot read {}: {}", path.string(), failure ? failure.message() : "No such file or directory"));
  }
  Collection collection = is_folder(path) ? files_below(path) : files_named_by(path);
  if (collection.files.empty()) throw InputError(fmt::format("{} has no shapes", path.string()));
  std::ranges::sort(collection.files, natural_less, &CollectionFile::id);
  const auto twice = std::ranges::adjacent_find(collection.files, {}, &CollectionFile::id);
  if (twice == collection.files.end()) return collection;
  throw InputError(fmt::format("{} names {} twice", path.string(), twice->id));
}

std::string collection_location(const fs::path& path) {
  std::error_code failure;
  const fs::path location = fs::weakly_canonical(fs::absolute(path), failure);
  const fs::path known = failure ? fs::absolute(path).lexically_normal() : location;
  return (known.has_filename() ? known : known.parent_path()).string();
}

fs::path collection_base(const fs::path& path) {
  const std::string extension = lower_case(path.extension().string());
  if (is_folder(path)) return path;
  return extension == ".json" ? location_in(path).root : path.parent_path();
}

fs::path default_index_path(const fs::path& collection, const fs::path& method) {
  fs::path path = fs::absolute(collection).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();  // "models/"
  std::string name = path.filename().string();
  if (!method.empty()) name.append(".").append(method.stem().string());
  return path.parent_path() / (name + ".search-index");
}

}  // namespace shapegauge

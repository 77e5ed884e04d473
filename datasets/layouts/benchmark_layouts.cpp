// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/layouts/benchmark_layouts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/classification.h"
#include "shapegauge/datasets/files/csv.h"
#include "shapegauge/datasets/files/model_ids.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

constexpr int shrec07_class_size = 20;
constexpr std::array<std::string_view, 20> shrec07_classes{
    "human", "cup",  "glasses", "airplane", "ant",       "chair", "octopus",  "table",   "teddy", "hand",
    "plier", "fish", "bird",    "spring",   "armadillo", "bust",  "mechanic", "bearing", "vase",  "fourleg"};

std::string id_of(const fs::path& file) { return fs::path(file).filename().replace_extension().string(); }

// Returns the number in the name of a file such as 12.off.
std::optional<int> number_of(const fs::path& file) {
  const std::string id = id_of(file);
  int number = 0;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), number);
  const bool whole = error == std::errc() && end == id.data() + id.size() && number > 0;
  return whole ? std::optional(number) : std::nullopt;
}

bool is_there(const fs::path& path) {
  std::error_code unknown;
  return fs::exists(path, unknown);
}

// Returns the name without its final digits; empty if there are none or nothing else.
std::string name_before_number(const fs::path& file) {
  const std::string id = id_of(file);
  const std::size_t end = id.find_last_not_of("0123456789") + 1;
  return end == id.size() ? "" : id.substr(0, end);
}

Dataset find_shrec07_dataset(const DatasetLocation& location) {
  Dataset dataset;
  for (const std::string_view name : shrec07_classes) dataset.classes.emplace_back(name);
  std::set<std::string> ids;
  for (const fs::path& file : model_files(location.root)) {
    const std::optional<int> number = number_of(file);
    if (!number || *number > shrec07_class_size * std::ssize(shrec07_classes)) {
      throw InputError(fmt::format("{}: the models of the layout \"shrec07\" are 1.off to {}.off", file.string(),
                                   shrec07_class_size * std::ssize(shrec07_classes)));
    }
    add_model({.id = id_of(file), .file = file, .label = (*number - 1) / shrec07_class_size}, ids, dataset);
  }
  std::ranges::sort(dataset.models, natural_less, &Model::id);
  return dataset;
}

bool looks_like_shrec07(const fs::path& root) {
  const std::vector<fs::path> files = model_files(root);
  return files.size() > 1 && std::ranges::all_of(files, [](const fs::path& file) {
           return number_of(file).value_or(shrec07_class_size * 20 + 1) <= shrec07_class_size * 20;
         });
}

Dataset find_psb_dataset(const DatasetLocation& location) {
  const Classification classification = read_classification(location.classification);
  const std::vector<std::string> ids = models_in_natural_order(classification);
  const std::vector<int> labels = class_labels(classification, ids, location.classification.string());
  Dataset dataset;
  for (const ModelClass& one : classification.classes) dataset.classes.push_back(one.name);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::string name = ids[i].starts_with('m') ? ids[i].substr(1) : ids[i];
    const std::optional<int> number = name == "0" ? std::optional(0) : number_of(name);
    if (!number) {
      throw InputError(fmt::format("{}: model {} is not a number, as the layout \"psb\" requires",
                                   location.classification.string(), quoted_word(ids[i])));
    }
    const fs::path folder = location.root / "db" / fmt::format("{}", *number / 100) / fmt::format("m{}", *number);
    dataset.models.push_back({.id = ids[i], .file = folder / fmt::format("m{}.off", *number), .label = labels[i]});
  }
  return dataset;
}

bool looks_like_psb(const fs::path& root) { return is_folder(root / "db" / "0") && is_folder(root / "classification"); }

Dataset find_named_dataset(const DatasetLocation& location) {
  Dataset dataset;
  std::set<std::string> ids;
  for (const fs::path& file : model_files(location.root)) {
    const std::string name = name_before_number(file);
    if (name.empty()) {
      throw InputError(fmt::format(
          "{}: expected a class and a number such as cat0.off, as the layout \"named\" requires", file.string()));
    }
    add_model({.id = id_of(file), .file = file, .label = label_of_class(name, dataset)}, ids, dataset);
  }
  std::ranges::sort(dataset.models, natural_less, &Model::id);
  return dataset;
}

bool looks_like_named(const fs::path& root) {
  const std::vector<fs::path> files = model_files(root);
  std::set<std::string> names;
  for (const fs::path& file : files) names.insert(name_before_number(file));
  std::set<fs::path> visited = visited_at_root(root);
  return names.size() > 1 && !names.contains("") &&
         std::ranges::none_of(unvisited(subfolders(root), visited), is_folder);
}

// Returns true for a link to a folder of the tree, which is visited under its own name.
bool is_link_into(const fs::path& root, const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_symlink(path, ignored) || is_broken_link(path)) return false;
  const fs::path target = canonical_or_same(path).lexically_relative(root);
  return std::ranges::none_of(target, [](const fs::path& part) { return part.string().starts_with('.'); });
}

Dataset find_tree_dataset(const DatasetLocation& location) {
  Dataset dataset;
  std::set<std::string> ids;
  const fs::path root = canonical_or_same(location.root);
  std::set<fs::path> visited = visited_at_root(root);
  std::vector<fs::path> waiting{location.root};
  while (!waiting.empty()) {
    const fs::path folder = waiting.back();
    waiting.pop_back();
    const bool is_root = folder == location.root;
    const std::string name = folder.lexically_relative(location.root).generic_string();
    if (!is_root && !is_readable_folder(folder)) {
      add_model({.id = name, .file = folder, .label = label_of_class(name, dataset)}, ids, dataset);
      continue;
    }
    for (const fs::path& file : is_root ? std::vector<fs::path>() : model_files(folder)) {
      add_model({.id = name + "/" + id_of(file), .file = file, .label = label_of_class(name, dataset)}, ids, dataset);
    }
    std::vector<fs::path> below = subfolders(folder);
    std::erase_if(below, [&](const fs::path& path) { return is_cyclic_link(path) || is_link_into(root, path); });
    below = unvisited(std::move(below), visited);
    waiting.insert(waiting.end(), below.rbegin(), below.rend());
  }
  std::ranges::sort(dataset.models, natural_less, &Model::id);
  return dataset;
}

bool looks_like_tree(const fs::path& root) {
  std::set<fs::path> visited = visited_at_root(root);
  const std::vector<fs::path> folders = unvisited(subfolders(root), visited);
  const auto holds_folders_only = [&](const fs::path& folder) {
    return is_readable_folder(folder) && model_files(folder).empty() &&
           std::ranges::any_of(unvisited(subfolders(folder), visited), is_folder) && !is_folder(folder / "train") &&
           !is_folder(folder / "test");
  };
  return std::ranges::any_of(folders, holds_folders_only);
}

std::size_t shapenet_column(const CsvRow& header, std::string_view name, const std::string& source) {
  const std::string lower = lower_case(std::string(name));
  if (const auto found = find_column(header, std::array<std::string_view, 1>{lower})) return *found;
  throw InputError(
      fmt::format("{}:{}: expected the columns id, synsetId, subSynsetId, modelId and split; there is no {}", source,
                  header.line, name));
}

fs::path shapenet_file(const fs::path& root, const std::string& split, const std::string& synset,
                       const std::string& id) {
  const std::string name = fmt::format("model_{}.obj", id);
  const fs::path flat = root / split / name;
  const fs::path nested = root / split / synset / name;
  return !is_there(flat) && is_there(nested) ? nested : flat;
}

Dataset find_shapenet_dataset(const DatasetLocation& location) {
  const std::string source = location.classification.string();
  const std::vector<CsvRow> rows = parse_word_table(read_file_bytes(location.classification), source);
  if (rows.empty()) throw InputError(fmt::format("{}: the file lists no models", source));
  const std::size_t id = shapenet_column(rows[0], "id", source);
  const std::size_t synset = shapenet_column(rows[0], "synsetId", source);
  const auto subclass = find_column(rows[0], std::array<std::string_view, 1>{"subsynsetid"});
  const std::size_t split = shapenet_column(rows[0], "split", source);
  Dataset dataset;
  std::set<std::string> ids;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    if (location.split != "all" && row.cells[split] != location.split) continue;
    add_model({.id = row.cells[id],
               .file = shapenet_file(location.root, row.cells[split], row.cells[synset], row.cells[id]),
               .label = label_of_class(row.cells[synset], dataset),
               .subclass = subclass && row.cells[*subclass] != row.cells[synset] ? row.cells[*subclass] : ""},
              ids, dataset);
  }
  std::ranges::sort(dataset.models, natural_less, &Model::id);
  return dataset;
}

bool looks_like_shapenet(const fs::path& root) {
  if (!is_there(root / "all.csv")) return false;
  return lower_case(read_file_bytes(root / "all.csv", 200)).find("synsetid") != std::string::npos;
}

}  // namespace

DatasetLayout psb_layout() {
  return {.name = "psb",
          .description = "Princeton Shape Benchmark",
          .find = find_psb_dataset,
          .default_classification = "classification/v1/base/test.cla",
          .recognises = looks_like_psb};
}

DatasetLayout shapenet_layout() {
  return {.name = "shapenet",
          .description = "ShapeNetCore of SHREC'17",
          .find = find_shapenet_dataset,
          .default_classification = "all.csv",
          .has_splits = true,
          .recognises = looks_like_shapenet};
}

DatasetLayout shrec07_layout() {
  return {.name = "shrec07",
          .description = "SHREC'07, 1.off to 400.off, 20 per class",
          .find = find_shrec07_dataset,
          .has_classification = false,
          .recognises = looks_like_shrec07};
}

DatasetLayout named_layout() {
  return {.name = "named",
          .description = "files named by class and number, such as cat0.off",
          .find = find_named_dataset,
          .has_classification = false,
          .recognises = looks_like_named};
}

DatasetLayout tree_layout() {
  return {.name = "tree",
          .description = "nested folders, one class per folder with models",
          .find = find_tree_dataset,
          .has_classification = false,
          .recognises = looks_like_tree};
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/layouts/layouts.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/datasets/files/classification.h"
#include "shapegauge/datasets/files/csv.h"
#include "shapegauge/datasets/files/model_ids.h"
#include "shapegauge/datasets/layouts/benchmark_layouts.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

/// Indices of the columns of a table of models.
struct ModelColumns {
  std::size_t id = 0;
  std::size_t path = 0;
  std::size_t name = 0;  ///< of the class
  std::optional<std::size_t> subclass;
};

ModelColumns model_columns(const CsvRow& header, const std::string& source) {
  static constexpr std::array<std::string_view, 3> ids{"id", "name", "model"};
  static constexpr std::array<std::string_view, 3> paths{"path", "file", "filename"};
  const auto required = [&](const std::optional<std::size_t>& column, std::string_view name) {
    if (column) return *column;
    throw InputError(fmt::format("{}:{}: the first row must name the columns id, path and class; there is no \"{}\"",
                                 source, header.line, name));
  };
  return {.id = required(find_column(header, ids), "id"),
          .path = required(find_column(header, paths), "path"),
          .name = required(find_class_column(header, source), "class"),
          .subclass = find_column(header, subclass_column_names)};
}

const std::string& cell(const CsvRow& row, std::size_t position, const std::string& name, const std::string& source) {
  if (row.cells[position].empty()) throw InputError(fmt::format("{}:{}: the {} is empty", source, row.line, name));
  return row.cells[position];
}

/// Finds a data set of the layout "csv": a table with the columns id, path and class, named in its first row in any
/// order and case, separated by commas, semicolons or tabs, and optionally subclass. Paths are relative to the root.
/// Additional columns are allowed. Throws InputError, with the line, for a table that is absent, empty or lacks a
/// column, a row of another length, an empty cell, and a repeated id.
Dataset find_csv_dataset(const DatasetLocation& location) {
  const std::string source = location.classification.string();
  const std::vector<CsvRow> rows = parse_word_table(read_file_bytes(location.classification), source);
  if (rows.size() < 2) throw InputError(fmt::format("{}: no models; expected rows id,path,class", source));
  const ModelColumns columns = model_columns(rows[0], source);

  Dataset dataset;
  std::map<std::string, std::size_t> lines;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    Model model{.id = cell(row, columns.id, "id", source),
                .file = location.root / cell(row, columns.path, "path", source),
                .label = label_of_class(cell(row, columns.name, "class", source), dataset),
                .subclass = columns.subclass ? row.cells[*columns.subclass] : ""};
    if (model.subclass == row.cells[columns.name]) model.subclass.clear();
    const auto [earlier, added] = lines.emplace(model.id, row.line);
    if (!added) {
      throw InputError(fmt::format("{}:{}: repeated model {}; it was first in line {}", source, row.line, model.id,
                                   earlier->second));
    }
    dataset.models.push_back(std::move(model));
  }
  std::ranges::sort(dataset.models, natural_less, &Model::id);
  return dataset;
}

/// Returns the models in the folder or, if it cannot be read, the folder itself, which then fails as a model.
std::vector<fs::path> models_or_itself(const fs::path& folder) {
  return is_readable_folder(folder) ? model_files(folder) : std::vector{folder};
}

/// Files of a class.
struct ClassFiles {
  std::vector<fs::path> files;
  std::vector<fs::path> repeated;  ///< links to folders visited before
};

/// Finds the files of a class: those of the split, and with "all" also those directly in the class's folder.
ClassFiles class_files(const fs::path& folder, const std::string& split, std::set<fs::path>& visited) {
  ClassFiles found;
  if (split == "all" || !is_readable_folder(folder)) found.files = models_or_itself(folder);
  for (const char* part : {"test", "train"}) {
    const bool there = is_folder(folder / part) || is_broken_link(folder / part);
    if (!there || (split != "all" && split != part)) continue;
    if (!visited.insert(canonical_or_same(folder / part)).second) {
      found.repeated.push_back(folder / part);
      continue;
    }
    const std::vector<fs::path> more = models_or_itself(folder / part);
    found.files.insert(found.files.end(), more.begin(), more.end());
  }
  return found;
}

/// Returns the end of a message about missing models: names the first of the links that were not followed.
std::string repeated_text(const std::vector<fs::path>& links) {
  return links.empty()
             ? ""
             : fmt::format("; {} is a link to a folder that contains it or was visited before", links.front().string());
}

/// Finds a data set of the layout "folders": a folder for each class, with the models, or with folders train and test
/// that contain them. The id of a model is its path below the root without the extension. An unreadable folder and the
/// folder of a class without models count as a model of the class, which check_models() then reports. Links to folders
/// visited before are skipped. Throws InputError if no class has models, and for two files of one id.
Dataset find_folders_dataset(const DatasetLocation& location) {
  Dataset dataset;
  std::set<std::string> ids;
  std::set<fs::path> visited = visited_at_root(location.root);
  std::vector<fs::path> links = subfolders(location.root);
  const std::vector<fs::path> folders = unvisited(links, visited);
  std::erase_if(links, [&](const fs::path& path) { return std::ranges::find(folders, path) != folders.end(); });
  bool has_files = false;
  for (const fs::path& folder : folders) {
    const auto [files, repeated] = class_files(folder, location.split, visited);
    const int label = static_cast<int>(dataset.classes.size());
    dataset.classes.push_back(folder.filename().string());
    has_files = has_files || !files.empty();
    if (files.empty()) {
      const std::string fault = fmt::format(
          "{}: no models ({}) in this class{}{}", folder.string(), fmt::join(unambiguous_shape_extensions(), ", "),
          location.split == "all" ? "" : fmt::format(" for the split \"{}\"", location.split), repeated_text(repeated));
      add_model({.id = dataset.classes.back(), .file = folder, .label = label, .fault = fault}, ids, dataset);
    }
    for (const fs::path& file : files) {
      // An unreadable folder may have a dot in its name.
      const fs::path named = is_model_file(file) ? fs::path(file).replace_extension() : file;
      add_model({.id = named.lexically_relative(location.root).generic_string(), .file = file, .label = label}, ids,
                dataset);
    }
  }
  if (dataset.classes.empty()) {
    const auto models = static_cast<std::int64_t>(model_files(location.root).size());
    throw InputError(fmt::format(
        "{}: the layout \"folders\" needs a folder for each class; found none{}{}", location.root.string(),
        models == 0 ? ""
                    : fmt::format("; the classes of its {} must be in a file: a .cla, or a table id,path,class",
                                  count_text(models, "model", "models")),
        repeated_text(links)));
  }
  if (!has_files) throw InputError(dataset.models.front().fault);
  std::ranges::sort(dataset.models, natural_less, &Model::id);
  return dataset;
}

/// Returns the models' files by canonical id.
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

/// Finds a data set of the layout "shrec11": one folder of models, T0.off, T1.off, ..., and a .cla file with the models
/// and their classes. A model of the .cla file without a file gets the expected file name. Throws InputError for an
/// absent or invalid .cla file, and two files for one model.
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

void require_folder(const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return;
  const char* const fault = is_cyclic_link(folder)        ? "symbolic links lead in a circle"
                            : fs::exists(folder, ignored) ? "is not a folder"
                                                          : "no such folder";
  throw InputError(fmt::format("{}: {}; expected the folder of the data set", folder.string(), fault));
}

}  // namespace

Registry<DatasetLayout>& dataset_layouts() {
  static Registry<DatasetLayout> all(
      "layout of data sets",
      {
          {.name = "shrec11",
           .description = "T*.off and a .cla classification",
           .find = find_shrec11_dataset,
           .default_classification = "test.cla"},
          {.name = "folders",
           .description = "one folder per class, optionally with subfolders train and test",
           .find = find_folders_dataset,
           .has_splits = true,
           .has_classification = false},
          {.name = "csv",
           .description = "CSV table with columns id,path,class",
           .find = find_csv_dataset,
           .default_classification = "models.csv"},
          psb_layout(),
          shapenet_layout(),
          shrec07_layout(),
          named_layout(),
          tree_layout(),
      },
      has_functions<&DatasetLayout::find>);
  return all;
}

Dataset find_dataset(const DatasetLocation& location) {
  require_folder(location.root);
  const DatasetLayout& layout = dataset_layouts().at(location.layout);
  Dataset dataset = layout.find(location);
  if (dataset.models.empty()) {
    throw InputError(fmt::format("{}: no models ({}) in the layout \"{}\"", location.root.string(),
                                 fmt::join(unambiguous_shape_extensions(), ", "), location.layout));
  }
  if (!layout.has_classification) {
    // Models of other splits are not skipped entries.
    DatasetLocation whole = location;
    whole.split = "all";
    dataset.skipped =
        skipped_entries(location.root, location.split == "all" ? dataset.models : layout.find(whole).models);
  }
  return dataset;
}

bool is_model_table(const fs::path& path) {
  const std::string extension = lower_case(path.extension().string());
  return extension == ".csv" || extension == ".tsv";
}

DatasetLocation recognise_dataset(const fs::path& root, const fs::path& classification) {
  require_folder(root);
  if (!classification.empty()) {
    const bool table = is_model_table(classification);
    const std::string layout = table ? "csv" : psb_layout().recognises(root) ? "psb" : "shrec11";
    return {.layout = layout, .root = root, .classification = classification};
  }
  for (const DatasetLayout& layout : dataset_layouts().entries()) {
    const bool has_default = !layout.default_classification.empty();
    const fs::path default_path = has_default ? root / layout.default_classification : fs::path();
    std::error_code unreadable;  // then reading it reports why, such as a looping link
    const bool there = has_default && (fs::exists(default_path, unreadable) || unreadable);
    const bool recognised = layout.recognises != nullptr ? layout.recognises(root) : there;
    if (recognised) return {.layout = std::string(layout.name), .root = root, .classification = default_path};
  }
  return {.layout = "folders", .root = root, .classification = {}};
}

std::vector<ModelFailure> check_models(const Dataset& dataset) {
  std::vector<ModelFailure> failures;
  for (std::size_t i = 0; i < dataset.models.size(); ++i) {
    const Model& model = dataset.models[i];
    try {
      if (!model.fault.empty()) throw InputError(model.fault);
      check_shape_header(model.file);
    } catch (const InputError& error) {
      failures.push_back({.model = i, .message = error.what()});
    }
  }
  return failures;
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/layouts/labels.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <set>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/datasets/files/compressed_files.h"
#include "shapegauge/datasets/files/csv.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/datasets/layouts/layouts.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

// Collects models by the names of their classes and rejects repeated models.
class Collector {
 public:
  explicit Collector(std::string where, ModelKeys keys = {}) : where_(std::move(where)), keys_(std::move(keys)) {}

  void add(const std::string& id, const std::string& class_name, const std::string& where) {
    const auto [known, added] = ids_.emplace(keys_.of(id), id);
    if (!added && known->second == id) throw InputError(fmt::format("{}: repeated model {}", where, quoted_word(id)));
    if (!added) {
      throw InputError(fmt::format(
          "{}: model {} is the same as {}: extensions of shapes, and T before a number, are ignored; remove one", where,
          quoted_word(id), quoted_word(known->second)));
    }
    const auto [position, is_new] = positions_.emplace(class_name, classes_.classes.size());
    if (is_new) classes_.classes.push_back({.name = class_name, .parent = std::nullopt, .models = {}});
    classes_.classes[position->second].models.push_back(id);
  }

  [[nodiscard]] Classification result() const {
    if (classes_.classes.empty()) throw InputError(fmt::format("{}: no models", where_));
    return classes_;
  }

 private:
  std::string where_;
  ModelKeys keys_;
  Classification classes_;
  std::map<std::string, std::size_t> positions_;
  std::unordered_map<std::string, std::string> ids_;  // by key
};

struct Roles {
  bool query = true;
  bool target = true;
};

Roles roles_of(const std::string& split, const std::string& where) {
  if (split.empty() || split == "both") return {};
  if (split == "query" || split == "test" || split == "probe") return {.query = true, .target = false};
  if (split == "target" || split == "train" || split == "gallery") return {.query = false, .target = true};
  throw InputError(fmt::format("{}: the split is {}; known are query (test, probe), target (train, gallery) and both",
                               where, quoted_word(split)));
}

ModelLabels all_are_both(Classification classification, const fs::path& path) {
  const std::vector<std::string> models = models_in_file_order(classification);
  return {.classification = std::move(classification),
          .queries = models,
          .targets = models,
          .models = models,
          .source = path.string()};
}

// Models of the class -1 of a .cla file, which holds all without a class, are targets only.
ModelLabels labels_of_classification(Classification classification, const fs::path& path) {
  ModelLabels labels = all_are_both(std::move(classification), path);
  const auto& classes = labels.classification.classes;
  const auto unclassified = std::ranges::find(classes, "-1", &ModelClass::name);
  if (unclassified == classes.end()) return labels;
  labels.separate_sets = std::erase_if(labels.queries, [&](const std::string& id) {
                           return std::ranges::find(unclassified->models, id) != unclassified->models.end();
                         }) > 0;
  return labels;
}

// Columns of a table of labels.
struct LabelColumns {
  std::optional<std::size_t> id;
  std::optional<std::size_t> name;
  std::optional<std::size_t> subclass;
  std::optional<std::size_t> split;
  bool named = false;  // the first row says so
};

LabelColumns columns_of(const CsvRow& first, const std::string& source) {
  static constexpr std::array<std::string_view, 5> ids{"id", "name", "model", "file", "filename"};
  static constexpr std::array<std::string_view, 1> splits{"split"};
  LabelColumns columns{.id = find_column(first, ids),
                       .name = find_class_column(first, source),
                       .subclass = find_column(first, subclass_column_names),
                       .split = find_column(first, splits)};
  columns.named = columns.id || columns.name;
  const bool two = first.cells.size() == 2;
  if (!columns.named && two)
    return {.id = 0, .name = 1, .subclass = std::nullopt, .split = std::nullopt, .named = false};
  if (columns.id && columns.name) return columns;
  throw InputError(
      fmt::format("{}: the first row must name the columns id and class (and may name subclass and split), unless "
                  "there are two columns only",
                  source));
}

void check_cells(const CsvRow& row, const LabelColumns& where_is, const std::string& where) {
  if (row.cells[*where_is.id].empty() || row.cells[*where_is.name].empty()) {
    throw InputError(fmt::format("{}: the {} is empty", where, row.cells[*where_is.id].empty() ? "id" : "class"));
  }
}

// Returns the keys of the models in the rows from `first` on.
ModelKeys keys_of(const std::vector<CsvRow>& rows, std::size_t first, std::size_t id_column) {
  std::vector<std::string> ids;
  for (std::size_t i = first; i < rows.size(); ++i) ids.push_back(rows[i].cells[id_column]);
  return ModelKeys(ids);
}

ModelLabels parse_label_table(const std::vector<CsvRow>& rows, const std::string& source) {
  if (rows.empty()) throw InputError(fmt::format("{}: no models", source));
  const LabelColumns columns = columns_of(rows.front(), source);
  const std::size_t first = columns.named ? 1 : 0;
  ModelLabels labels;
  labels.keys = keys_of(rows, first, *columns.id);
  Collector collector(source, labels.keys);
  for (std::size_t i = first; i < rows.size(); ++i) {
    const std::string where = fmt::format("{}:{}", source, rows[i].line);
    const std::vector<std::string>& cells = rows[i].cells;
    check_cells(rows[i], columns, where);
    collector.add(cells[*columns.id], cells[*columns.name], where);
    labels.models.push_back(cells[*columns.id]);
    if (columns.subclass && !cells[*columns.subclass].empty() && cells[*columns.subclass] != cells[*columns.name]) {
      labels.subclasses.emplace(labels.keys.of(cells[*columns.id]), cells[*columns.subclass]);
    }
    const Roles roles = columns.split ? roles_of(cells[*columns.split], where) : Roles{};
    if (roles.query) labels.queries.push_back(cells[*columns.id]);
    if (roles.target) labels.targets.push_back(cells[*columns.id]);
    if (!roles.query || !roles.target) labels.separate_sets = labels.split = true;
  }
  labels.classification = collector.result();
  labels.listed = true;
  labels.source = source;
  return labels;
}

// Returns labels of models without ids, in order.
ModelLabels labels_in_order(const std::vector<std::string>& names, const std::string& source) {
  Collector collector(source);
  ModelLabels labels;
  for (const std::string& name : names) {
    labels.models.push_back(std::to_string(labels.models.size()));
    collector.add(labels.models.back(), name, source);
  }
  labels.classification = collector.result();
  labels.queries = labels.targets = labels.models;
  labels.listed = true;
  labels.without_ids = true;
  labels.source = source;
  return labels;
}

ModelLabels string_labels(const std::vector<std::string>& names, const std::string& source) {
  const auto empty = std::ranges::find(names, std::string());
  if (empty != names.end()) {
    throw InputError(fmt::format("{}: entry {} (counted from 0) is empty; every model needs a class", source,
                                 empty - names.begin()));
  }
  const auto is_missing = [](const std::string& name) {
    return std::ranges::find(missing_value_words, name) != missing_value_words.end();
  };
  if (const auto missing = std::ranges::find_if(names, is_missing); missing != names.end()) {
    throw InputError(fmt::format(
        "{}: entry {} (counted from 0) is {}, the text that NumPy makes of missing values; every model needs a class",
        source, missing - names.begin(), quoted_word(*missing)));
  }
  return labels_in_order(names, source);
}

ModelLabels read_label_array(const fs::path& path) {
  const std::string bytes = read_plain_bytes(path);
  if (const auto names = parse_npy_strings(bytes, path.string())) return string_labels(*names, path.string());
  const DistanceMatrix numbers = parse_npy(bytes, path.string(), TableShape::any);
  if (numbers.rows() != 1 && numbers.cols() != 1) {
    throw InputError(fmt::format("{}: expected a one-dimensional array of labels, found {} x {}", path.string(),
                                 numbers.rows(), numbers.cols()));
  }
  std::vector<std::string> names;
  for (Eigen::Index i = 0; i < numbers.size(); ++i) {
    const double number = numbers.data()[i];
    if (!(std::abs(number) < 1e15) || number != std::floor(number)) {
      throw InputError(
          fmt::format("{}: entry {} (counted from 0) is {}; labels must be integers", path.string(), i, number));
    }
    names.push_back(fmt::format("{:.0f}", number));
  }
  return labels_in_order(names, path.string());
}

/// Parses lines "id class" as rows of a table; none if they may also be a list of classes.
std::vector<CsvRow> rows_of_words(std::string_view text) {
  std::vector<CsvRow> rows;
  std::set<std::string> ids;
  std::set<std::string> names;
  std::size_t number = 0;
  for (const std::string_view whole : split_lines(text)) {
    ++number;
    const std::string_view line = trim(whole);
    if (line.empty()) continue;
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const std::string id(line.substr(0, end));
    const std::string name(trim(line.substr(end)));
    const bool header = rows.empty() && lower_case(id) == "id";
    const bool is_id = header || id.find_first_of("0123456789") != std::string::npos;
    if (!is_id || name.empty() || !ids.insert(id).second) return {};
    names.insert(name);
    rows.push_back({.cells = {id, name}, .line = number});
  }
  if (names.size() == rows.size()) return {};
  return rows;
}

// Throws InputError for files of other formats, which would be read as a list of classes.
void check_is_text(const fs::path& path, std::string_view text) {
  static constexpr std::array<std::string_view, 9> others{".npz", ".mat",  ".matrix", ".html", ".pdf",
                                                          ".png", ".jpeg", ".jpg",    ".svg"};
  const std::string extension = format_extension(path);
  const std::vector<std::string_view> shapes = unambiguous_shape_extensions();
  const bool is_other = std::ranges::find(others, extension) != others.end() ||
                        std::ranges::find(shapes, extension) != shapes.end() || unsupported_format_advice(path);
  if (!is_other && text.find('\0') == std::string_view::npos) return;
  throw InputError(fmt::format("{}: {}; labels are a folder, a .cla file, a .npy array, or text (.csv, .tsv, .txt)",
                               path.string(),
                               is_other ? fmt::format("{} files have no labels", extension) : "not text in UTF-8"));
}

/// Empties the lines at the beginning that are comments.
std::string without_comments(std::string text) {
  for (std::size_t begin = 0; text.compare(begin, 2, "# ") == 0;) {
    text.erase(begin, std::min(text.find_first_of("\r\n", begin), text.size()) - begin);
    begin = std::min(text.find_first_not_of("\r\n", begin), text.size());
  }
  return text;
}

ModelLabels read_list(const fs::path& path) {
  if (format_extension(path) == ".npy") return read_label_array(path);
  const std::string text = without_comments(read_plain_text(path));
  check_is_text(path, text);
  if (first_separator(text)) return parse_label_table(parse_word_table(text, path.string()), path.string());
  if (const std::vector<CsvRow> rows = rows_of_words(text); !rows.empty())
    return parse_label_table(rows, path.string());
  std::vector<std::string> names;
  for (const std::string_view line : split_lines(text)) {
    if (!trim(line).empty()) names.emplace_back(trim(line));
  }
  const bool header = !names.empty() && (names.front() == "class" || names.front() == "label");
  if (header) names.erase(names.begin());
  return labels_in_order(names, path.string());
}

Classification read_folders(const fs::path& path) {
  const Dataset dataset = find_dataset({.layout = "folders", .root = path, .classification = {}, .split = "all"});
  Classification classification;
  for (const std::string& name : dataset.classes) {
    classification.classes.push_back({.name = name, .parent = std::nullopt, .models = {}});
  }
  for (const Model& model : dataset.models) {
    classification.classes[static_cast<std::size_t>(model.label)].models.push_back(model.id);
  }
  return classification;
}

// Returns the classes from the root down to the class itself.
std::vector<std::size_t> line_of(const Classification& classification, std::size_t position) {
  std::vector<std::size_t> line = {position};
  while (classification.classes[line.back()].parent) line.push_back(*classification.classes[line.back()].parent);
  std::ranges::reverse(line);
  return line;
}

Classification at_level(const Classification& classification, std::size_t level, const std::string& source) {
  if (level == 0) return classification;
  const bool hierarchy =
      std::ranges::any_of(classification.classes, [](const ModelClass& known) { return known.parent.has_value(); });
  if (!hierarchy) {
    throw InputError(fmt::format("{}: no level {}, because no class has a parent; omit `level`", source, level));
  }
  Collector collector(source);
  for (std::size_t i = 0; i < classification.classes.size(); ++i) {
    const std::vector<std::size_t> line = line_of(classification, i);
    const ModelClass& ancestor = classification.classes[line[std::min(level, line.size()) - 1]];
    for (const std::string& model : classification.classes[i].models) collector.add(model, ancestor.name, source);
  }
  return collector.result();
}

std::unordered_map<std::string, std::string> class_names_by_model(const Classification& classification,
                                                                  const ModelKeys& keys) {
  std::unordered_map<std::string, std::string> names;
  for (const ModelClass& known : classification.classes) {
    for (const std::string& model : known.models) names.emplace(keys.of(model), known.name);
  }
  return names;
}

/// Adds the subclasses of a file's models under the keys of `labels`; known ones stay.
void add_subclasses(const ModelLabels& from, ModelLabels& labels) {
  for (const std::string& model : from.models) {
    const auto found = from.subclasses.find(from.keys.of(model));
    if (found != from.subclasses.end()) labels.subclasses.emplace(labels.keys.of(model), found->second);
  }
}

/// Returns true for the names that NumPy, pandas, R and spreadsheets write for missing values.
bool may_mean_missing(std::string_view name) {
  static constexpr std::array<std::string_view, 3> others{"NA", "N/A", "#N/A"};
  return std::ranges::count(missing_value_words, name) + std::ranges::count(others, name) > 0;
}

/// Returns the class of that name, adding it if missing.
ModelClass& class_named(const std::string& name, std::vector<ModelClass>& classes) {
  const auto same = std::ranges::find(classes, name, &ModelClass::name);
  if (same != classes.end()) return *same;
  return classes.emplace_back(ModelClass{.name = name, .parent = std::nullopt, .models = {}});
}

}  // namespace

std::vector<std::string> missing_class_warnings(const ModelLabels& labels) {
  std::vector<std::string> warnings;
  for (const ModelClass& known : labels.classification.classes) {
    if (known.models.empty() || !may_mean_missing(known.name)) continue;
    warnings.push_back(fmt::format(
        "{}: {} the class {}, which many programs write for missing values; if these models are unlabelled, remove "
        "them, "
        "or give each a class of its own: it is then not a query",
        labels.source, count_text(std::ssize(known.models), "model has", "models have"), quoted_word(known.name)));
  }
  return warnings;
}

ModelLabels read_labels(const fs::path& path, std::size_t level) {
  if (is_folder(path)) return all_are_both(at_level(read_folders(path), level, path.string()), path);
  if (lower_case(path.extension().string()) == ".cla") {
    return labels_of_classification(at_level(read_classification(path), level, path.string()), path);
  }
  ModelLabels labels = read_list(path);
  labels.classification = at_level(labels.classification, level, labels.source);
  return labels;
}

TaskLabels read_query_and_target_labels(const fs::path& queries, const fs::path& targets, std::size_t level) {
  ModelLabels of_queries = read_labels(queries, level);
  ModelLabels of_targets = read_labels(targets, level);
  of_queries.queries = of_queries.models;
  of_targets.targets = of_targets.models;
  std::vector<ModelClass> classes;
  for (const ModelClass& known : of_queries.classification.classes) class_named(known.name, classes);
  for (ModelClass& known : of_targets.classification.classes) {
    class_named(known.name, of_queries.classification.classes);
    class_named(known.name, classes).models = std::move(known.models);
  }
  of_targets.classification.classes = std::move(classes);
  of_queries.separate_sets = of_targets.separate_sets = true;
  of_queries.split = of_targets.split = false;
  return {.queries = std::move(of_queries), .targets = std::move(of_targets)};
}

ModelLabels read_shared_labels(const fs::path& queries, const fs::path& targets, std::size_t level) {
  const ModelLabels of_queries = read_labels(queries, level);
  const ModelLabels of_targets = read_labels(targets, level);
  if (of_queries.without_ids || of_targets.without_ids) {
    throw InputError(fmt::format("{}: the file has no ids to share; with `shared_ids` both files of labels need ids",
                                 (of_queries.without_ids ? queries : targets).string()));
  }
  ModelLabels labels{.classification = of_queries.classification,
                     .queries = of_queries.models,
                     .targets = of_targets.models,
                     .models = of_queries.models,
                     .separate_sets = true,
                     .listed = of_queries.listed && of_targets.listed,
                     .source = fmt::format("{} and {}", queries.string(), targets.string()),
                     .keys = of_queries.keys};
  labels.keys.add(of_targets.keys);
  add_subclasses(of_queries, labels);
  add_subclasses(of_targets, labels);
  const auto class_of_query = class_names_by_model(of_queries.classification, labels.keys);
  for (const ModelClass& added : of_targets.classification.classes) {
    ModelClass& same = class_named(added.name, labels.classification.classes);
    for (const std::string& model : added.models) {
      const auto known = class_of_query.find(labels.keys.of(model));
      if (known == class_of_query.end()) {
        same.models.push_back(model);
        labels.models.push_back(model);
      } else if (known->second != added.name) {
        throw InputError(fmt::format("{}: model {} has the class {} here and {} in {}", targets.string(),
                                     quoted_word(model), quoted_word(added.name), quoted_word(known->second),
                                     queries.string()));
      }
    }
  }
  if (labels.models.size() == labels.targets.size()) labels.models = labels.targets;  // a file of all: its order
  return labels;
}

}  // namespace shapegauge

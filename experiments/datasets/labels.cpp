#include "shapegauge/experiments/datasets/labels.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <optional>
#include <unordered_map>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/datasets/layouts.h"
#include "shapegauge/experiments/files/classification.h"
#include "shapegauge/experiments/files/csv.h"
#include "shapegauge/experiments/files/model_ids.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

// Collects models under the names of their classes and refuses a model that is there already.
class Collector {
 public:
  explicit Collector(const std::string& where) : where_(where) {}

  void add(const std::string& id, const std::string& class_name, const std::string& where) {
    const auto [known, added] = class_of_model_.emplace(canonical_model_id(id), class_name);
    if (!added) throw InputError(fmt::format("{}: the model {} occurs twice", where, quoted_word(id)));
    const auto [position, is_new] = positions_.emplace(class_name, classes_.classes.size());
    if (is_new) classes_.classes.push_back({.name = class_name, .parent = std::nullopt, .models = {}});
    classes_.classes[position->second].models.push_back(id);
  }

  [[nodiscard]] Classification result() const {
    if (classes_.classes.empty()) throw InputError(fmt::format("{}: there are no models", where_));
    return classes_;
  }

 private:
  std::string where_;
  Classification classes_;
  std::map<std::string, std::size_t> positions_;
  std::unordered_map<std::string, std::string> class_of_model_;
};

std::optional<std::size_t> column_of(const CsvRow& header, std::string_view name) {
  const auto found = std::ranges::find(header.cells, name);
  if (found == header.cells.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header.cells.begin());
}

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
  std::vector<std::string> models = models_in_file_order(classification);
  return {.classification = std::move(classification),
          .queries = models,
          .targets = models,
          .separate_sets = false,
          .source = path.string()};
}

ModelLabels read_table(const fs::path& path) {
  const std::string source = path.string();
  const std::vector<CsvRow> rows = parse_csv(read_file_bytes(path), source);
  const auto id = rows.empty() ? std::nullopt : column_of(rows[0], "id");
  const auto name = rows.empty() ? std::nullopt : column_of(rows[0], "class");
  if (!id || !name) throw InputError(fmt::format("{}: the first row must name the columns id and class", source));
  const auto split = column_of(rows[0], "split");
  Collector collector(source);
  ModelLabels labels;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::string where = fmt::format("{}:{}", source, rows[i].line);
    const std::vector<std::string>& cells = rows[i].cells;
    if (cells.size() != rows[0].cells.size()) {
      throw InputError(
          fmt::format("{}: {} cells where the first row has {}", where, cells.size(), rows[0].cells.size()));
    }
    if (cells[*id].empty() || cells[*name].empty()) {
      throw InputError(fmt::format("{}: the {} is empty", where, cells[*id].empty() ? "id" : "class"));
    }
    collector.add(cells[*id], cells[*name], where);
    const Roles roles = split ? roles_of(cells[*split], where) : Roles{};
    if (roles.query) labels.queries.push_back(cells[*id]);
    if (roles.target) labels.targets.push_back(cells[*id]);
    if (!roles.query || !roles.target) labels.separate_sets = true;
  }
  labels.classification = collector.result();
  labels.source = source;
  return labels;
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

// The classes from the root down to the class itself.
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
    throw InputError(fmt::format("{}: no class has a parent, so there is no level {} to take", source, level));
  }
  Collector collector(source);
  for (std::size_t i = 0; i < classification.classes.size(); ++i) {
    const std::vector<std::size_t> line = line_of(classification, i);
    const ModelClass& taken = classification.classes[line[std::min(level, line.size()) - 1]];
    for (const std::string& model : classification.classes[i].models) collector.add(model, taken.name, source);
  }
  return collector.result();
}

}  // namespace

ModelLabels read_labels(const fs::path& path, std::size_t level) {
  if (path.extension() == ".csv") {
    ModelLabels labels = read_table(path);
    labels.classification = at_level(labels.classification, level, labels.source);
    return labels;
  }
  const Classification read = fs::is_directory(path) ? read_folders(path) : read_classification(path);
  return all_are_both(at_level(read, level, path.string()), path);
}

ModelLabels read_query_and_target_labels(const fs::path& queries, const fs::path& targets, std::size_t level) {
  const ModelLabels of_queries = read_labels(queries, level);
  const ModelLabels of_targets = read_labels(targets, level);
  ModelLabels labels{.classification = of_queries.classification,
                     .queries = models_in_file_order(of_queries.classification),
                     .targets = models_in_file_order(of_targets.classification),
                     .separate_sets = true,
                     .source = fmt::format("{} and {}", queries.string(), targets.string())};
  std::unordered_map<std::string, std::string> class_of_query;
  for (const ModelClass& known : of_queries.classification.classes) {
    for (const std::string& model : known.models) class_of_query.emplace(canonical_model_id(model), known.name);
  }
  std::vector<ModelClass>& classes = labels.classification.classes;
  for (const ModelClass& added : of_targets.classification.classes) {
    auto same = std::ranges::find(classes, added.name, &ModelClass::name);
    if (same == classes.end()) {
      classes.push_back({.name = added.name, .parent = std::nullopt, .models = {}});
      same = std::prev(classes.end());
    }
    for (const std::string& model : added.models) {
      const auto known = class_of_query.find(canonical_model_id(model));
      if (known == class_of_query.end()) {
        same->models.push_back(model);
      } else if (known->second != added.name) {
        throw InputError(fmt::format("{}: model {} is of class {} here and of {} in {}", targets.string(),
                                     quoted_word(model), quoted_word(added.name), quoted_word(known->second),
                                     queries.string()));
      }
    }
  }
  return labels;
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/evaluation/evaluate_files.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/datasets/files/compressed_files.h"
#include "shapegauge/datasets/files/model_ids.h"
#include "shapegauge/datasets/files/ranked_answers.h"
#include "shapegauge/datasets/layouts/labels.h"
#include "shapegauge/experiments/evaluation/evaluation_warnings.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/feature_checks.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

// Reads the ids in a file, one per line, skipping empty lines.
std::vector<std::string> read_ids(const fs::path& path) {
  const std::string text = read_plain_text(path);
  std::vector<std::string> ids;
  for (const std::string_view line : split_lines(text)) {
    const std::string_view id = trim(line);
    if (!id.empty()) ids.emplace_back(id);
  }
  return ids;
}

// Makes a matrix of distances between features, one row per model, computed on demand. Adds a warning about features.
OpenMatrix open_features(const EvaluationFiles& files, std::vector<std::string>& warnings) {
  const LabelledTable table = read_matrix(files.matrix, TableShape::any, files.variable);
  const auto features = std::make_shared<const Signatures>(table.numbers.cast<float>());
  const NamedDistance distance = feature_distance(files.distance);
  try {
    if (const auto warning = check_features(table.numbers)) warnings.push_back(*warning);
    distance_rows(*features, 0, std::min<Eigen::Index>(features->rows(), 1), distance);  // throws what others would
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("{}: {}", files.matrix.string(), error.what()));
  }
  const auto read = [features, distance](const MatrixBlock& block) -> DistanceMatrix {
    DistanceMatrix rows = distance_rows(*features, block.first_row, block.rows, distance);
    if (block.columns == rows.cols()) return rows;
    return rows.middleCols(block.first_column, block.columns);
  };
  return {.rows = features->rows(),
          .columns = features->rows(),
          .read = read,
          .row_ids = table.row_ids,
          .column_ids = table.row_ids};
}

OpenMatrix open_distances(const EvaluationFiles& files, TableShape shape, std::vector<std::string>& warnings) {
  if (!files.distance.empty()) return open_features(files, warnings);
  OpenMatrix matrix = open_matrix(files.matrix, shape, files.variable);
  if (!files.similarity) return matrix;
  matrix.read = [similarities = std::move(matrix.read)](const MatrixBlock& block) -> DistanceMatrix {
    return -similarities(block);
  };
  return matrix;
}

// Throws InputError if the ids of a file are not those that the matrix has, if any.
void check_same_ids(const std::vector<std::string>& file_ids, const std::vector<std::string>& matrix_ids,
                    std::string_view what, const EvaluationFiles& files) {
  const ModelKeys keys(matrix_ids);
  for (std::size_t i = 0; i < std::min(file_ids.size(), matrix_ids.size()); ++i) {
    if (keys.of(file_ids[i]) == keys.of(matrix_ids[i])) continue;
    throw InputError(fmt::format("{} {} has the id {} in {}, but {} in {}", what, i + 1, quoted_word(matrix_ids[i]),
                                 files.matrix.string(), quoted_word(file_ids[i]), files.ids.string()));
  }
}

// Returns the ids of the rows and columns according to the files; empty if there are none.
MatrixIds ids_of_files(const OpenMatrix& matrix, const EvaluationFiles& files) {
  MatrixIds ids{.rows = matrix.row_ids, .columns = matrix.column_ids};
  if (!files.ids.empty()) {
    const std::vector<std::string> file_ids = read_ids(files.ids);
    if (file_ids.empty()) throw InputError(fmt::format("{} has no ids; expected one per line", files.ids.string()));
    check_same_ids(file_ids, ids.rows, "row", files);
    if (matrix.rows == matrix.columns) {
      check_same_ids(file_ids, ids.columns, "column", files);
      ids.columns = file_ids;
    }
    ids.rows = file_ids;
    if (ids.columns.empty()) {
      throw InputError(
          fmt::format("{} has the ids of the rows only, and the columns of {} have none; use a table with the ids of "
                      "both (.csv)",
                      files.ids.string(), files.matrix.string()));
    }
  }
  if (ids.rows.empty() || ids.columns.empty()) return {};
  return ids;
}

// Names the sources of the models of rows and of columns.
struct ModelSources {
  std::string rows;
  std::string columns;
};

void check_size(const OpenMatrix& matrix, const MatrixIds& ids, const ModelSources& sources,
                const EvaluationFiles& files) {
  const auto check = [&](Eigen::Index size, std::string_view what, std::size_t models, const std::string& source) {
    if (static_cast<std::size_t>(size) == models) return;
    throw InputError(fmt::format("{} has {} {}, but there are {} models in {}{}", files.matrix.string(), size, what,
                                 models, source,
                                 !files.targets.empty() && !files.shared_ids
                                     ? "; if the matrix is of all models and the ids of both files of labels name the "
                                       "same models, use `shared_ids`"
                                     : ""));
  };
  check(matrix.rows, "rows", ids.rows.size(), sources.rows);
  check(matrix.columns, "columns", ids.columns.size(), sources.columns);
}

// Returns true for a file of ranked lists. Throws InputError for settings of matrices that it cannot follow.
bool has_ranked_answers(const EvaluationFiles& files) {
  if (!is_ranked_answers_file(files.matrix)) return false;
  const std::array<std::pair<std::string_view, bool>, 5> of_matrices{{{"similarity", files.similarity},
                                                                      {"distance", !files.distance.empty()},
                                                                      {"order", files.order != RowOrder::automatic},
                                                                      {"ids", !files.ids.empty()},
                                                                      {"variable", !files.variable.empty()}}};
  for (const auto& [setting, is_set] : of_matrices) {
    if (!is_set) continue;
    throw InputError(fmt::format("{}: `{}` applies to matrices only, and the file has ranked lists",
                                 files.matrix.string(), setting));
  }
  return true;
}

EvaluationData data_of(const RankedAnswers& answers, RankedTask ranked) {
  if (2 * answers.reversed > answers.answers.size()) {
    ranked.task.warnings.push_back(fmt::format(
        "in {} of {} lists the scores rise with the rank: as in trec_eval, the highest score is the best and "
        "ranks are ignored; scores that are distances need a minus sign",
        answers.reversed, answers.answers.size()));
  }
  return {.distances = {}, .answers = std::move(ranked.answers), .name = answers.name, .task = std::move(ranked.task)};
}

// Gives models of a list without ids those of the matrix, in order.
void give_ids(const std::vector<std::string>& ids, ModelLabels& labels) {
  if (!labels.without_ids) return;
  if (ids.size() != labels.models.size()) {
    throw InputError(fmt::format("{}: the labels have no ids and there are {} of them, but the matrix names {} models",
                                 labels.source, labels.models.size(), ids.size()));
  }
  for (ModelClass& known : labels.classification.classes) {
    for (std::string& model : known.models) model = ids[std::stoul(model)];
  }
  labels.models = labels.queries = labels.targets = ids;
  labels.keys = ModelKeys(ids);
  labels.without_ids = false;
}

// Replaces ids that are the ends of the paths of labelled models, or the reverse, by those of the models: "m1" by
// "cat/m1". Changes nothing if an id is labelled as it is, or has no such model or several.
void match_ends_of_paths(std::vector<std::string>& ids, const ModelLabels& labels) {
  const auto path_of = [&](const std::string& id) { return "/" + labels.keys.of(id); };
  const auto name_of_path = [](const std::string& path) { return path.substr(path.rfind('/')); };
  std::unordered_map<std::string, const std::string*> models;  // by the last part of the path; null if repeated
  std::unordered_set<std::string> paths;
  for (const std::string& model : labels.models) {
    const std::string path = path_of(model);
    paths.insert(path);
    const auto [found, added] = models.emplace(name_of_path(path), &model);
    if (!added) found->second = nullptr;
  }
  std::vector<std::string> matched;
  for (const std::string& id : ids) {
    const std::string path = path_of(id);
    const auto found = models.find(name_of_path(path));
    if (paths.contains(path) || found == models.end() || found->second == nullptr) return;
    const std::string model = path_of(*found->second);
    if (!model.ends_with(path) && !path.ends_with(model)) return;
    matched.push_back(*found->second);
  }
  ids = std::move(matched);
}

// Refuses ids that are the first row of distances, of which the first is not a number.
void check_first_row(const std::vector<std::string>& ids, const ModelLabels& labels, const EvaluationFiles& files) {
  if (!files.ids.empty() || ids.size() + 1 != labels.models.size()) return;
  if (!std::ranges::all_of(ids, [](const std::string& id) { return parse_number(id).has_value(); })) return;
  std::unordered_set<std::string> labelled;
  for (const std::string& model : labels.models) labelled.insert(labels.keys.of(model));
  const auto is_labelled = [&](const std::string& id) { return labelled.contains(labels.keys.of(id)); };
  if (!labels.without_ids && std::ranges::all_of(ids, is_labelled)) return;
  throw InputError(fmt::format(
      "{}: the first row is taken for the ids of {} models, as its first cell is not a number, but {} has {} "
      "models; a matrix without ids must begin with a number",
      files.matrix.string(), ids.size(), labels.source, labels.models.size()));
}

// Warns of the assumed order of rows without ids if it is ambiguous.
void warn_of_order(const MatrixIds& assumed, const TaskLabels& labels, EvaluationData& data) {
  const bool listed = labels.queries.listed && labels.of_targets().listed;
  const RowOrder other = listed ? RowOrder::natural : RowOrder::file;
  const MatrixIds otherwise = labelled_ids(labels, {data.distances.rows, data.distances.columns}, other);
  if (assumed.rows == otherwise.rows && assumed.columns == otherwise.columns) return;
  const std::string& source = labels.queries.source;
  data.task.warnings.push_back(listed ? fmt::format("rows are assumed to be in the order of {}, which differs from the "
                                                    "natural order of ids (2 before 10); for that use `order=natural`",
                                                    source)
                                      : fmt::format("rows are assumed to be in natural order of ids (2 before 10), "
                                                    "which differs from the order of {}; for that use `order=file`",
                                                    source));
}

std::vector<std::string> label_warnings(const TaskLabels& labels) {
  std::vector<std::string> warnings = missing_class_warnings(labels.queries);
  if (labels.targets) std::ranges::move(missing_class_warnings(*labels.targets), std::back_inserter(warnings));
  if (labels.queries.split) {
    warnings.push_back(fmt::format("{}: the column split makes {} of {} models queries, and {} targets",
                                   labels.queries.source, labels.queries.queries.size(), labels.queries.models.size(),
                                   labels.queries.targets.size()));
  }
  return warnings;
}

// Adds the ids that a run has stored next to its matrices.
EvaluationFiles with_stored_ids(EvaluationFiles files) {
  const fs::path stored = files.matrix.parent_path() / stored_ids_name;
  std::error_code unknown;
  const bool is_matrix = lower_case(files.matrix.extension().string()) == ".npy";
  if (is_matrix && files.ids.empty() && files.order == RowOrder::automatic && fs::exists(stored, unknown))
    files.ids = stored;
  return files;
}

EvaluationData open_labelled(const EvaluationFiles& files) {
  TaskLabels labels = read_task_labels(files);
  std::vector<std::string> warnings = label_warnings(labels);
  if (has_ranked_answers(files)) {
    const RankedAnswers answers = read_ranked_answers(files.matrix);
    EvaluationData data = data_of(answers, task_of_answers(answers, labels, files.unanswered));
    std::ranges::move(warnings, std::back_inserter(data.task.warnings));
    return data;
  }
  const TableShape shape = labels.queries.separate_sets ? TableShape::any : TableShape::square;
  EvaluationData data{
      .distances = open_distances(files, shape, warnings), .symmetric = !files.distance.empty(), .task = {}};
  MatrixIds ids = ids_of_files(data.distances, files);
  const bool named = !ids.rows.empty();
  if (named) {
    check_first_row(ids.rows, labels.queries, files);
    give_ids(ids.rows, labels.queries);
    if (labels.targets) give_ids(ids.columns, *labels.targets);
    match_ends_of_paths(ids.rows, labels.queries);
    match_ends_of_paths(ids.columns, labels.of_targets());
  } else {
    ids = labelled_ids(labels, {data.distances.rows, data.distances.columns}, files.order);
  }
  const bool from_file = named && !files.ids.empty();
  check_size(data.distances, ids,
             {.rows = from_file ? files.ids.string() : labels.queries.source,
              .columns = from_file ? files.ids.string() : labels.of_targets().source},
             files);
  data.task = task_of_labels(ids, labels);
  std::ranges::move(warnings, std::back_inserter(data.task.warnings));
  if (!named && files.order == RowOrder::automatic) warn_of_order(ids, labels, data);
  return data;
}

EvaluationData open_judged(const EvaluationFiles& files) {
  const Judgements judgements = read_qrels(files.qrels);
  EvaluationData data;
  if (has_ranked_answers(files)) {
    const RankedAnswers answers = read_ranked_answers(files.matrix);
    data = data_of(answers, task_of_answers(answers, judgements, files.unanswered));
  } else {
    std::vector<std::string> warnings;
    data.distances = open_distances(files, TableShape::any, warnings);
    data.symmetric = !files.distance.empty();
    const MatrixIds ids = ids_of_files(data.distances, files);
    if (ids.rows.empty()) {
      throw InputError(
          fmt::format("{}: with judgements (qrels) the rows and columns need ids: a CSV with ids, or `ids`",
                      files.matrix.string()));
    }
    const std::string& source = files.ids.empty() ? files.matrix.string() : files.ids.string();
    check_size(data.distances, ids, {.rows = source, .columns = source}, files);
    data.task = task_of_judgements(ids, judgements, files.qrels.string());
    std::ranges::move(warnings, std::back_inserter(data.task.warnings));
  }
  if (judgements.graded) {
    data.task.warnings.emplace_back(
        "the judgements have grades above 1, which only nDCG and nDCG@N use; for all other measures, every positive "
        "grade means relevant");
  }
  return data;
}

// Evaluates the distances by rows and checks each row for anomalies.
Evaluation evaluate_rows(const EvaluationData& data, const EvaluationOptions& options, MatrixChecks& checks,
                         const RowProgress& progress) {
  if (data.task.coverage) return evaluate(data.answers, data.task.retrieval, options);
  const OpenMatrix& matrix = data.distances;
  const bool mirrored = data.task.same_rows_and_columns && !data.symmetric;
  const RowSource rows = [&](Eigen::Index first, Eigen::Index count) {
    if (progress) progress(first, matrix.rows);
    DistanceMatrix some =
        matrix.read({.first_row = first, .rows = count, .first_column = 0, .columns = matrix.columns});
    checks.add(some);
    if (mirrored) {
      checks.compare(
          some, first,
          matrix.read({.first_row = first, .rows = matrix.rows - first, .first_column = first, .columns = count}));
    }
    return some;
  };
  return evaluate(rows, data.task.retrieval, options);
}

// Suggests a possible fault of labels if each model has its own class.
std::string advice_on(const EvaluationFiles& files, const EvaluationTask& task) {
  if (files.labels.empty() || task.class_names.size() < 2 || task.class_names.size() < task.query_ids.size()) return "";
  return fmt::format(
      "; in {} each model has a different class; expected one class per line, or a table of ids and classes separated "
      "by commas, semicolons or tabs",
      files.labels.string());
}

}  // namespace

TaskLabels read_task_labels(const EvaluationFiles& files) {
  if (files.targets.empty() && files.shared_ids) throw InputError("`shared_ids` requires `targets`");
  if (files.targets.empty()) return {.queries = read_labels(files.labels, files.level)};
  if (files.shared_ids) return {.queries = read_shared_labels(files.labels, files.targets, files.level)};
  return read_query_and_target_labels(files.labels, files.targets, files.level);
}

EvaluationData open_evaluation_files(const EvaluationFiles& files) {
  if (files.labels.empty() == files.qrels.empty()) {
    throw InputError("exactly one of `labels` (classes of the models) and `qrels` (judgements) is required");
  }
  const EvaluationFiles complete = with_stored_ids(files);
  return files.qrels.empty() ? open_labelled(complete) : open_judged(complete);
}

std::vector<std::string> merged_warnings(std::span<const FileWarning> warnings, std::string_view noun) {
  std::vector<std::pair<FileWarning, std::size_t>> different;  // the first of each, and their number
  for (const FileWarning& warning : warnings) {
    const auto known = std::ranges::find_if(different, [&](const auto& one) { return one.first.text == warning.text; });
    if (known == different.end()) {
      different.emplace_back(warning, 1);
    } else {
      ++known->second;
    }
  }
  std::vector<std::string> merged;
  for (const auto& [first, count] : different) {
    merged.push_back(count == 1 ? fmt::format("{}: {}", first.file, first.text)
                                : fmt::format("{} {} (first: {}): {}", count, noun, first.file, first.text));
  }
  return merged;
}

EvaluatedFiles evaluate_files(const EvaluationFiles& files, const EvaluationOptions& options,
                              const RowProgress& progress) {
  EvaluatedFiles result{.data = open_evaluation_files(files), .evaluation = {}, .findings = {}, .warnings = {}};
  const EvaluationTask& task = result.data.task;
  MatrixChecks checks(task.same_rows_and_columns);
  try {
    result.evaluation = evaluate_rows(result.data, options, checks, progress);
  } catch (const ArgumentError& error) {
    throw InputError(fmt::format("{}: {}{}", files.matrix.string(), error.what(), advice_on(files, task)));
  }
  result.warnings = task.warnings;
  result.findings = checks.findings();
  if (!task.same_rows_and_columns && std::ranges::count(task.retrieval.own_column, -1) == 0) {
    result.findings.rows_at_zero = 0;  // the queries themselves, which are not in their lists
  }
  const std::vector<std::string> odd = matrix_warnings(result.findings, task.query_ids, files.similarity);
  result.warnings.insert(result.warnings.end(), odd.begin(), odd.end());
  for (const auto& warning :
       {task.coverage ? std::nullopt : chance_warning(result.evaluation, result.findings, task.retrieval),
        left_out_warning(result.evaluation, task.retrieval, options)}) {
    if (warning) result.warnings.push_back(*warning);
  }
  return result;
}

}  // namespace shapegauge

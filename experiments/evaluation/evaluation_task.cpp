// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/evaluation/evaluation_task.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/datasets/files/model_ids.h"

namespace shapegauge {

namespace {

// Positions of models by the keys of their ids; without keys, by the ids themselves.
class Positions {
 public:
  explicit Positions(const std::vector<std::string>& ids, std::optional<ModelKeys> keys) : keys_(std::move(keys)) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const bool added = by_key_.emplace(key(ids[i]), static_cast<Eigen::Index>(i)).second;
      if (!added && !repeated_) repeated_ = ids[i];
    }
  }

  // Returns the first position of a model, or -1.
  [[nodiscard]] Eigen::Index find(const std::string& id) const {
    const auto found = by_key_.find(key(id));
    return found == by_key_.end() ? -1 : found->second;
  }
  [[nodiscard]] std::size_t size() const { return by_key_.size(); }
  [[nodiscard]] const std::optional<std::string>& repeated() const { return repeated_; }
  [[nodiscard]] bool has_same_models(const Positions& other) const { return by_key_ == other.by_key_; }

 private:
  [[nodiscard]] std::string key(const std::string& id) const { return keys_ ? keys_->of(id) : id; }

  std::optional<ModelKeys> keys_;
  std::unordered_map<std::string, Eigen::Index> by_key_;
  std::optional<std::string> repeated_;
};

// Labels, for lookup by model.
class LabelledModels {
 public:
  struct Known {
    int label = 0;  // index of its class
    bool query = false;
    bool target = false;
    std::string subclass;
  };

  explicit LabelledModels(const ModelLabels& labels, bool is_one_of_two)
      : source_(labels.source), keys_(labels.keys), is_one_of_two_(is_one_of_two) {
    for (std::size_t i = 0; i < labels.classification.classes.size(); ++i) {
      for (const std::string& model : labels.classification.classes[i].models) {
        known_[keys_.of(model)].label = static_cast<int>(i);
      }
    }
    for (const auto& [model, subclass] : labels.subclasses) known_.at(model).subclass = subclass;
    for (const std::string& model : labels.queries) known_.at(keys_.of(model)).query = true;
    for (const std::string& model : labels.targets) known_.at(keys_.of(model)).target = true;
  }

  // Throws InputError if the model has no class.
  [[nodiscard]] const Known& at(const std::string& id) const {
    const auto found = known_.find(keys_.of(id));
    if (found != known_.end()) return found->second;
    throw InputError(fmt::format(
        "{}: model {} is in no class; add it to the file or remove the model{}", source_, quoted_word(id),
        is_one_of_two_ ? "; if the ids of both files of labels name the same models, use `shared_ids`" : ""));
  }

 private:
  std::string source_;
  ModelKeys keys_;
  bool is_one_of_two_;
  std::unordered_map<std::string, Known> known_;
};

std::string source_of(const TaskLabels& labels) {
  return labels.targets ? fmt::format("{} and {}", labels.queries.source, labels.targets->source)
                        : labels.queries.source;
}

// Sets the classes and subclasses of rows and columns.
void set_classes(const MatrixIds& ids, const TaskLabels& labels, RetrievalTask& task) {
  const LabelledModels of_rows(labels.queries, labels.targets.has_value());
  std::optional<LabelledModels> other;
  if (labels.targets) other.emplace(*labels.targets, true);
  const LabelledModels& of_columns = other ? *other : of_rows;
  std::vector<std::string> subclasses;
  for (const std::string& id : ids.rows) {
    const LabelledModels::Known& known = of_rows.at(id);
    task.query_classes.push_back(known.query ? known.label : no_class);
    subclasses.push_back(known.subclass);
  }
  for (const std::string& id : ids.columns) {
    const LabelledModels::Known& known = of_columns.at(id);
    task.target_classes.push_back(known.target ? known.label : no_class);
    subclasses.push_back(known.subclass);
  }
  const std::vector<int> numbers = number_subclasses(subclasses);
  if (numbers.empty()) return;
  const auto end_of_rows = numbers.begin() + std::ssize(ids.rows);
  task.query_subclasses.assign(numbers.begin(), end_of_rows);
  task.target_subclasses.assign(end_of_rows, numbers.end());
}

// Warns if ids of two sets of models are equal, which may be a misunderstanding.
void warn_of_shared_ids(const TaskLabels& labels, EvaluationTask& task) {
  if (!labels.targets || labels.queries.without_ids || labels.targets->without_ids) return;
  const Positions targets(labels.targets->models, labels.targets->keys);
  const auto shared =
      std::ranges::count_if(labels.queries.models, [&](const std::string& id) { return targets.find(id) >= 0; });
  if (shared == 0) return;
  task.warnings.push_back(fmt::format(
      "{} in both {} and {}; equal ids are treated as different models; if they are the same, use `shared_ids`",
      count_text(shared, "id is", "ids are"), labels.queries.source, labels.targets->source));
}

// Makes the task of rows and columns with labels, of which some models may be absent.
EvaluationTask labelled_task(const MatrixIds& ids, const TaskLabels& labels, const Positions& rows,
                             const Positions& columns) {
  for (const Positions* positions : {&rows, &columns}) {
    if (!positions->repeated()) continue;
    throw InputError(
        fmt::format("model {} is repeated among the rows, columns or lists to evaluate, not in {}; remove one",
                    quoted_word(*positions->repeated()), source_of(labels)));
  }
  EvaluationTask task{.retrieval = {},
                      .query_ids = ids.rows,
                      .same_rows_and_columns = !labels.targets && rows.has_same_models(columns)};
  for (const ModelClass& known : labels.queries.classification.classes) task.class_names.push_back(known.name);
  set_classes(ids, labels, task.retrieval);
  for (const std::string& id : ids.rows) {
    task.retrieval.own_column.push_back(labels.targets ? -1 : columns.find(id));
  }
  warn_of_shared_ids(labels, task);
  return task;
}

void check_labelled_models(const std::vector<std::string>& models, const Positions& positions,
                           const std::string& source) {
  for (const std::string& id : models) {
    if (positions.find(id) >= 0) continue;
    throw InputError(
        fmt::format("{}: model {} has a class but is not among the {} models with distances; remove it here", source,
                    quoted_word(id), positions.size()));
  }
}

// Makes the task of rows and columns with judgements; each query is a class of its own.
EvaluationTask judged_task(const MatrixIds& ids, const Judgements& judgements, const Positions& rows,
                           const Positions& columns, const std::string& source) {
  const auto find = [&](const std::string& id, const Positions& positions) {
    const Eigen::Index found = positions.find(id);
    if (found >= 0) return found;
    throw InputError(
        fmt::format("{}: {} is judged but is not in the matrix; remove its judgements, or use the ids of the matrix",
                    source, quoted_word(id)));
  };
  EvaluationTask task{.retrieval = {}, .query_ids = ids.rows, .class_names = ids.rows, .warnings = {}};
  RetrievalTask& retrieval = task.retrieval;
  retrieval.target_classes.assign(ids.columns.size(), 0);
  retrieval.query_classes.assign(ids.rows.size(), no_class);
  retrieval.own_column.assign(ids.rows.size(), -1);
  for (auto* table : {&retrieval.judged, &retrieval.judged_irrelevant}) table->resize(ids.rows.size());
  retrieval.grades.resize(ids.rows.size());
  for (const Judgements::Judged& judged : judgements.queries) {
    const auto row = static_cast<std::size_t>(find(judged.query, rows));
    retrieval.query_classes[row] = static_cast<int>(row);
    std::map<Eigen::Index, int> grades;
    for (std::size_t i = 0; i < judged.relevant.size(); ++i) {
      grades.emplace(find(judged.relevant[i], columns), judged.grades[i]);
    }
    for (const auto& [column, grade] : grades) {
      retrieval.judged[row].push_back(column);
      retrieval.grades[row].push_back(grade);
    }
    for (const std::string& model : judged.irrelevant) {
      retrieval.judged_irrelevant[row].push_back(find(model, columns));
    }
    std::ranges::sort(retrieval.judged_irrelevant[row]);
  }
  return task;
}

// Adds the answer to a query with its models as columns.
void add_answer(const RankedAnswers::Answer& answer, const Positions& columns, const RetrievalTask& task,
                RankedAnswerLists& answers) {
  std::vector<ListedModel>& models = answers.emplace_back();
  std::unordered_set<Eigen::Index> seen;
  for (const auto& [model, distance] : answer.models) {
    const Eigen::Index column = columns.find(model);
    if (column < 0 || task.target_classes[static_cast<std::size_t>(column)] == no_class) {
      throw InputError(fmt::format(
          "the ranked list of query {} has the model {}, which is not a target; remove it, or add it to the targets",
          quoted_word(answer.query), quoted_word(model)));
    }
    if (!seen.insert(column).second) {
      throw InputError(
          fmt::format("the ranked list of query {} has the model {} more than once (extensions, and T before a number, "
                      "are ignored); remove one",
                      quoted_word(answer.query), quoted_word(model)));
    }
    models.push_back({.column = column, .distance = distance});
  }
}

// Describes the lengths of lists: "3", or "3 to 9".
std::string lengths_text(const ListCoverage& coverage) {
  return coverage.shortest == coverage.longest ? fmt::format("{}", coverage.longest)
                                               : fmt::format("{} to {}", coverage.shortest, coverage.longest);
}

// Warns if some queries have no list, or lists lack models or are too short for the best score.
void warn_of_coverage(std::string_view queries, Unanswered unanswered, EvaluationTask& task) {
  const ListCoverage& coverage = task.coverage.value();
  if (const std::size_t missing = coverage.queries - coverage.answered; missing > 0) {
    task.warnings.push_back(
        fmt::format("{} of {} {} have no ranked list: {}", missing, coverage.queries, queries,
                    unanswered == Unanswered::count
                        ? "their scores are 0"
                        : fmt::format("the scores are of the other {}, as in trec_eval; `missing_queries=zero` counts "
                                      "the missing ones with scores of 0",
                                      coverage.answered)));
  }
  if (coverage.incomplete > 0) {
    task.warnings.push_back(fmt::format(
        "{} of {} lists have fewer models than are relevant (lists of {} models); missing relevant models count as not "
        "found, and even the best order of such a list scores below 1",
        coverage.incomplete, coverage.answered, lengths_text(coverage)));
  }
  // Lists may lack one model, the query itself.
  if (const auto models = std::ssize(task.retrieval.target_classes); coverage.shortest + 1 < models) {
    task.warnings.push_back(
        fmt::format("the lists have {} of {} models; the others count as not found, which can lower measures of deep "
                    "ranks, such as ST, DCG and mAP",
                    lengths_text(coverage), models));
  }
}

// Computes the coverage of the answers, which are those of the first rows, and `missing` queries without one.
ListCoverage coverage_of(const RankedAnswerLists& answers, const RetrievalTask& task, std::size_t missing) {
  const std::vector<std::size_t> relevant = relevant_counts(task);
  ListCoverage coverage{.queries = missing, .shortest = std::ssize(task.target_classes)};
  for (std::size_t row = 0; row < answers.size(); ++row) {
    if (task.query_classes[row] == no_class) continue;
    const auto length = std::ranges::count_if(
        answers[row], [&](const ListedModel& model) { return model.column != task.own_column[row]; });
    ++coverage.queries;
    ++coverage.answered;
    coverage.shortest = std::min(coverage.shortest, length);
    coverage.longest = std::max(coverage.longest, length);
    if (static_cast<std::size_t>(length) < relevant[row]) ++coverage.incomplete;
  }
  if (coverage.answered == 0) coverage.shortest = 0;
  return coverage;
}

// Adds the queries without an answer that count to the rows; `missing` are all of them.
void add_rows(const std::vector<std::string>& missing, Unanswered unanswered, MatrixIds& ids) {
  if (unanswered == Unanswered::count) ids.rows.insert(ids.rows.end(), missing.begin(), missing.end());
}

// Describes the coverage, and gives queries without a list an empty one.
RankedTask with_coverage(RankedTask ranked, std::size_t missing, std::string_view queries, Unanswered unanswered) {
  ranked.task.coverage = coverage_of(ranked.answers, ranked.task.retrieval, missing);
  warn_of_coverage(queries, unanswered, ranked.task);
  ranked.answers.resize(ranked.task.query_ids.size());
  return ranked;
}

}  // namespace

MatrixIds labelled_ids(const TaskLabels& labels, const MatrixSize& size, RowOrder order) {
  MatrixIds ids{.rows = labels.queries.queries, .columns = labels.of_targets().targets};
  const bool queries_by_targets = static_cast<std::size_t>(size.rows) == ids.rows.size() &&
                                  static_cast<std::size_t>(size.columns) == ids.columns.size();
  if (!queries_by_targets && !labels.targets) ids.rows = ids.columns = labels.queries.models;
  const bool listed = labels.queries.listed && labels.of_targets().listed;
  if (order == RowOrder::natural || (order == RowOrder::automatic && !listed)) {
    std::ranges::sort(ids.rows, natural_less);
    std::ranges::sort(ids.columns, natural_less);
  }
  return ids;
}

EvaluationTask task_of_labels(const MatrixIds& ids, const TaskLabels& labels) {
  const Positions rows(ids.rows, labels.queries.keys);
  const Positions columns(ids.columns, labels.of_targets().keys);
  EvaluationTask task = labelled_task(ids, labels, rows, columns);
  check_labelled_models(labels.queries.queries, rows, labels.queries.source);
  check_labelled_models(labels.of_targets().targets, columns, labels.of_targets().source);
  return task;
}

EvaluationTask task_of_judgements(const MatrixIds& ids, const Judgements& judgements, const std::string& source) {
  const Positions rows(ids.rows, ModelKeys(ids.rows));
  const Positions columns(ids.columns, ModelKeys(ids.columns));
  EvaluationTask task = judged_task(ids, judgements, rows, columns, source);
  task.same_rows_and_columns = ids.rows == ids.columns;
  for (std::size_t row = 0; row < ids.rows.size(); ++row) {
    task.retrieval.own_column[row] = columns.find(ids.rows[row]);
  }
  return task;
}

RankedTask task_of_answers(const RankedAnswers& answers, const TaskLabels& labels, Unanswered unanswered) {
  MatrixIds ids;
  for (const RankedAnswers::Answer& answer : answers.answers) ids.rows.push_back(answer.query);
  const Positions answered(ids.rows, labels.queries.keys);
  std::vector<std::string> missing;
  for (const std::string& id : labels.queries.queries) {
    if (answered.find(id) < 0) missing.push_back(id);
  }
  add_rows(missing, unanswered, ids);
  ids.columns = labels.of_targets().targets;
  std::ranges::sort(ids.columns, std::greater<>(),
                    [&](const std::string& id) { return labels.of_targets().keys.of(id); });
  const Positions columns(ids.columns, labels.of_targets().keys);
  RankedTask ranked{.answers = {},
                    .task = labelled_task(ids, labels, Positions(ids.rows, labels.queries.keys), columns)};
  const LabelledModels known(labels.of_targets(), labels.targets.has_value());
  for (const RankedAnswers::Answer& answer : answers.answers) {
    for (const auto& [model, distance] : answer.models) static_cast<void>(known.at(model));  // or throws
    add_answer(answer, columns, ranked.task.retrieval, ranked.answers);
  }
  return with_coverage(std::move(ranked), missing.size(), "queries", unanswered);
}

RankedTask task_of_answers(const RankedAnswers& answers, const Judgements& judgements, Unanswered unanswered) {
  std::set<std::string> unanswered_queries;
  std::set<std::string, std::greater<>> models;
  for (const Judgements::Judged& judged : judgements.queries) {
    unanswered_queries.insert(judged.query);
    for (const auto* judged_models : {&judged.relevant, &judged.irrelevant}) {
      models.insert(judged_models->begin(), judged_models->end());
    }
  }
  MatrixIds ids;
  std::vector<const RankedAnswers::Answer*> judged_answers;
  for (const RankedAnswers::Answer& answer : answers.answers) {
    for (const auto& [model, distance] : answer.models) models.insert(model);
    if (unanswered_queries.erase(answer.query) == 0) continue;
    ids.rows.push_back(answer.query);
    judged_answers.push_back(&answer);
  }
  Judgements counted = judgements;
  std::vector<std::string> missing;
  for (const Judgements::Judged& judged : judgements.queries) {
    if (unanswered_queries.contains(judged.query)) missing.push_back(judged.query);
  }
  if (unanswered == Unanswered::left_out) {
    std::erase_if(counted.queries, [&](const auto& judged) { return unanswered_queries.contains(judged.query); });
  }
  add_rows(missing, unanswered, ids);
  if (ids.rows.empty()) throw InputError("none of the queries is judged; lists and judgements need the same ids");
  ids.columns.assign(models.begin(), models.end());
  const Positions columns(ids.columns, std::nullopt);
  RankedTask ranked{.answers = {},
                    .task = judged_task(ids, counted, Positions(ids.rows, std::nullopt), columns, "the judgements")};
  for (const RankedAnswers::Answer* answer : judged_answers) {
    add_answer(*answer, columns, ranked.task.retrieval, ranked.answers);
  }
  if (const auto unjudged = std::ssize(answers.answers) - std::ssize(judged_answers); unjudged > 0) {
    ranked.task.warnings.push_back(count_text(unjudged, "query has", "queries have") +
                                   " no judgements; omitted from all scores");
  }
  return with_coverage(std::move(ranked), missing.size(), "judged queries", unanswered);
}

bool is_fit_for_report(const EvaluationTask& task) {
  const RetrievalTask& retrieval = task.retrieval;
  const bool all_classified = std::ranges::find(retrieval.query_classes, no_class) == retrieval.query_classes.end() &&
                              retrieval.query_classes == retrieval.target_classes;
  return task.same_rows_and_columns && all_classified && retrieval.judged.empty() && !task.coverage;
}

}  // namespace shapegauge

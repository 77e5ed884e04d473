#include "shapegauge/experiments/evaluation/evaluation_task.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/datasets/files/model_ids.h"
#include "shapegauge/datasets/files/model_keys.h"

namespace shapegauge {

namespace {

using Columns = std::map<std::string, Eigen::Index, std::greater<>>;  // of models, in trec_eval's order of the tied

// Positions of models.
struct Places {
  ModelKeys keys;
  std::unordered_map<std::string, Eigen::Index> by_key;

  [[nodiscard]] bool contains(const std::string& id) const { return by_key.contains(keys.of(id)); }
  bool operator==(const Places&) const = default;
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

  explicit LabelledModels(const ModelLabels& labels) : source_(labels.source), keys_(labels.keys) {
    for (std::size_t i = 0; i < labels.classification.classes.size(); ++i) {
      for (const std::string& model : labels.classification.classes[i].models) {
        known_[key(model)].label = static_cast<int>(i);
      }
    }
    for (const auto& [model, subclass] : labels.subclasses) known_.at(model).subclass = subclass;
    for (const std::string& model : labels.queries) known_.at(key(model)).query = true;
    for (const std::string& model : labels.targets) known_.at(key(model)).target = true;
  }

  // Throws InputError if the model has no class.
  [[nodiscard]] const Known& at(const std::string& id) const {
    const auto found = known_.find(key(id));
    if (found != known_.end()) return found->second;
    throw InputError(fmt::format("{}: model {} is in no class; add it to the file or leave the model out", source_,
                                 quoted_word(id)));
  }

  [[nodiscard]] std::string key(const std::string& id) const { return keys_.of(id); }

 private:
  std::string source_;
  ModelKeys keys_;
  std::unordered_map<std::string, Known> known_;
};

// Sets the subclasses of rows and columns, if any model has one.
void set_subclasses(const LabelledModels& models, const std::vector<std::string>& rows,
                    const std::vector<std::string>& columns, RetrievalTask& task) {
  std::vector<std::string> names;
  for (const auto* ids : {&rows, &columns}) {
    for (const std::string& id : *ids) names.push_back(models.at(id).subclass);
  }
  const std::vector<int> numbers = numbered_subclasses(names);
  if (numbers.empty()) return;
  const auto end_of_rows = numbers.begin() + std::ssize(rows);
  task.query_subclasses.assign(numbers.begin(), end_of_rows);
  task.target_subclasses.assign(end_of_rows, numbers.end());
}

std::vector<std::string> class_names_of(const ModelLabels& labels) {
  std::vector<std::string> names;
  for (const ModelClass& known : labels.classification.classes) names.push_back(known.name);
  return names;
}

Places unique_places(const std::vector<std::string>& ids, const ModelLabels& labels) {
  Places places{.keys = labels.keys, .by_key = {}};
  for (const std::string& id : ids) {
    const auto next = static_cast<Eigen::Index>(places.by_key.size());
    if (places.by_key.emplace(places.keys.of(id), next).second) continue;
    throw InputError(
        fmt::format("model {} occurs twice among the models to look up in {}", quoted_word(id), labels.source));
  }
  return places;
}

Places first_places(const std::vector<std::string>& ids) {
  Places places{.keys = ModelKeys(ids), .by_key = {}};
  for (std::size_t i = 0; i < ids.size(); ++i) {
    places.by_key.emplace(places.keys.of(ids[i]), static_cast<Eigen::Index>(i));
  }
  return places;
}

// Returns the position of a model, or -1.
Eigen::Index place_or_none(const std::string& id, const Places& places) {
  const auto found = places.by_key.find(places.keys.of(id));
  return found == places.by_key.end() ? -1 : found->second;
}

void check_all_there(const std::vector<std::string>& wanted, const Places& places, const std::string& source) {
  for (const std::string& id : wanted) {
    if (places.contains(id)) continue;
    throw InputError(fmt::format("{}: model {} is classified but is not among the {} models that are there", source,
                                 quoted_word(id), places.by_key.size()));
  }
}

void number(Columns& columns) {
  Eigen::Index next = 0;
  for (auto& [id, column] : columns) column = next++;
}

DistanceMatrix nothing_found(std::size_t rows, std::size_t columns) {
  return DistanceMatrix::Constant(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns),
                                  std::numeric_limits<double>::quiet_NaN());
}

void warn_of_unjudged(std::size_t count, EvaluationTask& task) {
  if (count == 0) return;
  task.warnings.push_back(count_text(static_cast<std::int64_t>(count), "query has", "queries have") +
                          " no judgements; omitted from all scores");
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
        fmt::format("{} of {} {} have no answer: {}", missing, coverage.queries, queries,
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

// Computes the coverage of the first `answered` rows, which have lists, and `missing` queries without one.
ListCoverage coverage_of(const RankedTask& ranked, Eigen::Index answered, std::size_t missing) {
  const RetrievalTask& task = ranked.task.retrieval;
  const std::vector<std::size_t> relevant = relevant_counts(task);
  ListCoverage coverage{.queries = missing, .shortest = ranked.distances.cols()};
  for (Eigen::Index row = 0; row < answered; ++row) {
    const auto i = static_cast<std::size_t>(row);
    if (task.query_classes[i] == no_class) continue;
    Eigen::Index length = 0;
    for (Eigen::Index column = 0; column < ranked.distances.cols(); ++column) {
      if (column != task.own_column[i] && !std::isnan(ranked.distances(row, column))) ++length;
    }
    ++coverage.queries;
    ++coverage.answered;
    coverage.shortest = std::min(coverage.shortest, length);
    coverage.longest = std::max(coverage.longest, length);
    if (static_cast<std::size_t>(length) < relevant[i]) ++coverage.incomplete;
  }
  if (coverage.answered == 0) coverage.shortest = 0;
  return coverage;
}

// Gives each query a row, empty without a list, and describes the coverage. `answered` queries have lists; `missing`
// ones have none.
RankedTask finished(RankedTask ranked, Eigen::Index answered, std::size_t missing, std::string_view queries,
                    Unanswered unanswered) {
  const Eigen::Index rows = std::ssize(ranked.task.query_ids);
  ranked.distances.conservativeResize(rows, Eigen::NoChange);
  ranked.distances.bottomRows(rows - answered).setConstant(std::numeric_limits<double>::quiet_NaN());
  ranked.task.coverage = coverage_of(ranked, answered, missing);
  warn_of_coverage(queries, unanswered, ranked.task);
  return ranked;
}

// Sets the relevant columns of a row with their grades, and the columns judged as not relevant.
template <typename Place>
void set_judged(const Judgements::Judged& judged, std::size_t row, const Place& place, RetrievalTask& task) {
  std::vector<std::pair<Eigen::Index, int>> relevant;
  for (std::size_t i = 0; i < judged.relevant.size(); ++i) {
    relevant.emplace_back(place(judged.relevant[i]), judged.grades[i]);
  }
  std::ranges::sort(relevant);
  for (const auto& [column, grade] : relevant) {
    task.judged[row].push_back(column);
    task.grades[row].push_back(grade);
  }
  for (const std::string& model : judged.irrelevant) task.judged_irrelevant[row].push_back(place(model));
  std::ranges::sort(task.judged_irrelevant[row]);
}

void resize_judged(std::size_t rows, RetrievalTask& task) {
  task.judged.resize(rows);
  task.grades.resize(rows);
  task.judged_irrelevant.resize(rows);
}

// With judgements, every query has its own class.
void add_judged_query(const Judgements::Judged& judged, const Columns& columns, EvaluationTask& task) {
  const std::size_t row = task.query_ids.size();
  task.retrieval.query_classes.push_back(static_cast<int>(row));
  task.class_names.push_back(judged.query);
  task.query_ids.push_back(judged.query);
  task.retrieval.own_column.push_back(-1);
  resize_judged(row + 1, task.retrieval);
  set_judged(
      judged, row, [&](const std::string& model) { return columns.at(model); }, task.retrieval);
}

// Models that are listed or judged.
Columns columns_of(const RankedAnswers& answers, const Judgements& judgements) {
  Columns columns;
  for (const RankedAnswers::Answer& answer : answers.answers) {
    for (const auto& [model, distance] : answer.models) columns.emplace(model, 0);
  }
  for (const Judgements::Judged& judged : judgements.queries) {
    for (const auto* models : {&judged.relevant, &judged.irrelevant}) {
      for (const std::string& model : *models) columns.emplace(model, 0);
    }
  }
  number(columns);
  return columns;
}

// Task of ranked answers with labels, built query by query.
class LabelledAnswers {
 public:
  LabelledAnswers(const ModelLabels& labels, std::size_t answers) : queries_(labels.queries), models_(labels) {
    for (const std::string& target : labels.targets) columns_.emplace(models_.key(target), 0);
    number(columns_);
    EvaluationTask& task = ranked_.task;
    task.class_names = class_names_of(labels);
    for (const auto& [id, column] : columns_) task.retrieval.target_classes.push_back(models_.at(id).label);
    task.retrieval.lists_may_end_early = true;
    ranked_.distances = nothing_found(answers, columns_.size());
  }

  void add(const RankedAnswers::Answer& answer) {
    const auto row = static_cast<Eigen::Index>(ranked_.task.query_ids.size());
    add_query(answer.query);
    if (!answered_.insert(models_.key(answer.query)).second) {
      throw InputError(fmt::format("the query {} has two spellings", quoted_word(answer.query)));
    }
    for (const auto& [model, distance] : answer.models) {
      if (!models_.at(model).target) {
        throw InputError(fmt::format("the answer to {} has the model {}, which is not a target",
                                     quoted_word(answer.query), quoted_word(model)));
      }
      double& entry = ranked_.distances(row, columns_.at(models_.key(model)));
      if (!std::isnan(entry)) {
        throw InputError(fmt::format("the answer to {} has a model twice, once as {}", quoted_word(answer.query),
                                     quoted_word(model)));
      }
      entry = distance;
    }
  }

  // Adds a query without its answer.
  void add_query(const std::string& id) {
    const LabelledModels::Known& known = models_.at(id);
    const auto own = columns_.find(models_.key(id));
    ranked_.task.query_ids.push_back(id);
    ranked_.task.retrieval.query_classes.push_back(known.query ? known.label : no_class);
    ranked_.task.retrieval.own_column.push_back(own == columns_.end() ? -1 : own->second);
  }

  // Returns the labelled queries without an answer.
  [[nodiscard]] std::vector<std::string> unanswered() const {
    std::vector<std::string> missing;
    std::ranges::copy_if(queries_, std::back_inserter(missing),
                         [&](const std::string& id) { return !answered_.contains(models_.key(id)); });
    return missing;
  }

  RankedTask task() && {
    std::vector<std::string> targets;
    for (const auto& [id, column] : columns_) targets.push_back(id);
    set_subclasses(models_, ranked_.task.query_ids, targets, ranked_.task.retrieval);
    return std::move(ranked_);
  }

 private:
  std::span<const std::string> queries_;
  LabelledModels models_;
  Columns columns_;
  RankedTask ranked_;
  std::set<std::string> answered_;
};

}  // namespace

MatrixIds labelled_ids(const ModelLabels& labels, const MatrixSize& size, RowOrder order) {
  MatrixIds ids{.rows = labels.queries, .columns = labels.targets};
  const bool queries_by_targets = static_cast<std::size_t>(size.rows) == ids.rows.size() &&
                                  static_cast<std::size_t>(size.columns) == ids.columns.size();
  if (!queries_by_targets) ids.rows = ids.columns = labels.models;
  if (order == RowOrder::natural || (order == RowOrder::usual && !labels.listed)) {
    std::ranges::sort(ids.rows, natural_less);
    std::ranges::sort(ids.columns, natural_less);
  }
  return ids;
}

EvaluationTask task_of_labels(const MatrixIds& ids, const ModelLabels& labels) {
  const LabelledModels models(labels);
  const Places rows = unique_places(ids.rows, labels);
  const Places columns = unique_places(ids.columns, labels);
  EvaluationTask task{.retrieval = {},
                      .query_ids = ids.rows,
                      .class_names = class_names_of(labels),
                      .same_rows_and_columns = rows == columns,
                      .warnings = {}};
  for (const std::string& id : ids.rows) {
    const LabelledModels::Known& known = models.at(id);
    task.retrieval.query_classes.push_back(known.query ? known.label : no_class);
    task.retrieval.own_column.push_back(place_or_none(id, columns));
  }
  for (const std::string& id : ids.columns) {
    const LabelledModels::Known& known = models.at(id);
    task.retrieval.target_classes.push_back(known.target ? known.label : no_class);
  }
  set_subclasses(models, ids.rows, ids.columns, task.retrieval);
  check_all_there(labels.queries, rows, labels.source);
  check_all_there(labels.targets, columns, labels.source);
  return task;
}

EvaluationTask task_of_judgements(const MatrixIds& ids, const Judgements& judgements, const std::string& source) {
  const Places rows = first_places(ids.rows);
  const Places columns = first_places(ids.columns);
  const auto place = [&](const std::string& id, const Places& places) {
    const Eigen::Index found = place_or_none(id, places);
    if (found >= 0) return found;
    throw InputError(fmt::format("{}: {} is judged but is not in the matrix", source, quoted_word(id)));
  };
  EvaluationTask task{.retrieval = {},
                      .query_ids = ids.rows,
                      .class_names = ids.rows,
                      .same_rows_and_columns = ids.rows == ids.columns,
                      .warnings = {}};
  task.retrieval.target_classes.assign(ids.columns.size(), 0);
  task.retrieval.query_classes.assign(ids.rows.size(), no_class);
  resize_judged(ids.rows.size(), task.retrieval);
  for (const std::string& id : ids.rows) task.retrieval.own_column.push_back(place_or_none(id, columns));
  for (const Judgements::Judged& judged : judgements.queries) {
    const Eigen::Index row = place(judged.query, rows);
    const auto i = static_cast<std::size_t>(row);
    task.retrieval.query_classes[i] = static_cast<int>(row);
    set_judged(
        judged, i, [&](const std::string& model) { return place(model, columns); }, task.retrieval);
  }
  return task;
}

RankedTask task_of_answers(const RankedAnswers& answers, const ModelLabels& labels, Unanswered unanswered) {
  LabelledAnswers built(labels, answers.answers.size());
  for (const RankedAnswers::Answer& answer : answers.answers) built.add(answer);
  const std::vector<std::string> missing = built.unanswered();
  if (unanswered == Unanswered::count) {
    for (const std::string& id : missing) built.add_query(id);
  }
  return finished(std::move(built).task(), std::ssize(answers.answers), missing.size(), "queries", unanswered);
}

RankedTask task_of_answers(const RankedAnswers& answers, const Judgements& judgements, Unanswered unanswered) {
  const Columns columns = columns_of(answers, judgements);
  RankedTask ranked;
  EvaluationTask& task = ranked.task;
  task.retrieval.target_classes.assign(columns.size(), 0);
  task.retrieval.lists_may_end_early = true;
  ranked.distances = nothing_found(answers.answers.size(), columns.size());
  std::unordered_map<std::string, const Judgements::Judged*> unanswered_queries;
  for (const Judgements::Judged& judged : judgements.queries) unanswered_queries.emplace(judged.query, &judged);
  std::size_t unjudged = 0;
  for (const RankedAnswers::Answer& answer : answers.answers) {
    const auto judged = unanswered_queries.find(answer.query);
    if (judged == unanswered_queries.end()) {
      ++unjudged;
      continue;
    }
    const auto row = static_cast<Eigen::Index>(task.query_ids.size());
    for (const auto& [model, distance] : answer.models) ranked.distances(row, columns.at(model)) = distance;
    add_judged_query(*judged->second, columns, task);
    unanswered_queries.erase(judged);
  }
  const auto answered_rows = std::ssize(task.query_ids);
  if (unanswered == Unanswered::count) {
    for (const Judgements::Judged& judged : judgements.queries) {
      if (unanswered_queries.contains(judged.query)) add_judged_query(judged, columns, task);
    }
  }
  warn_of_unjudged(unjudged, task);
  return finished(std::move(ranked), answered_rows, unanswered_queries.size(), "judged queries", unanswered);
}

bool is_fit_for_report(const EvaluationTask& task) {
  const RetrievalTask& retrieval = task.retrieval;
  const bool all_classified = std::ranges::find(retrieval.query_classes, no_class) == retrieval.query_classes.end() &&
                              retrieval.query_classes == retrieval.target_classes;
  return task.same_rows_and_columns && all_classified && retrieval.judged.empty() && !retrieval.lists_may_end_early;
}

}  // namespace shapegauge

#include "shapegauge/experiments/evaluation/answers_input.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

#include "shapegauge/core/error.h"
#include "shapegauge/experiments/datasets/model_ids.h"
#include "shapegauge/experiments/text/quoted_word.h"

namespace shapegauge {
namespace {

using Columns = std::map<std::string, Eigen::Index, std::greater<>>;

void number(Columns& columns) {
  Eigen::Index next = 0;
  for (auto& [id, column] : columns) column = next++;
}

void set_row(const RankedAnswers::Answer& answer, const Columns& columns,
             const std::function<std::string(const std::string&)>& key, Eigen::Index row, DistanceMatrix& distances) {
  for (const auto& [model, distance] : answer.models) distances(row, columns.at(key(model))) = distance;
}

DistanceMatrix nothing_found(std::size_t rows, std::size_t columns) {
  return DistanceMatrix::Constant(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns),
                                  std::numeric_limits<double>::quiet_NaN());
}

void note_missing(std::size_t count, std::string_view what, EvaluationInput& input) {
  if (count == 0) return;
  input.notes.push_back(
      fmt::format("{} {}: left out of all figures, as trec_eval does (without its option -c)", count, what));
}

// A class of its own for every query: judgements know no classes.
void add_judged_query(const std::string& query, std::vector<Eigen::Index> relevant, Eigen::Index own,
                      EvaluationInput& input) {
  input.task.query_classes.push_back(static_cast<int>(input.class_names.size()));
  input.class_names.push_back(query);
  input.query_ids.push_back(query);
  input.task.own_column.push_back(own);
  std::ranges::sort(relevant);
  input.task.judged.push_back(std::move(relevant));
}

}  // namespace

EvaluationInput input_of_answers(const RankedAnswers& answers, const ClassifiedModels& classified) {
  EvaluationInput input;
  Columns columns;
  for (const std::string& target : classified.labels().targets) columns.emplace(canonical_model_id(target), 0);
  number(columns);
  for (const ModelClass& known : classified.labels().classification.classes) input.class_names.push_back(known.name);
  for (const auto& [id, column] : columns) input.task.target_classes.push_back(classified.at(id).label);
  input.task.lists_may_end_early = true;
  input.distances = nothing_found(answers.answers.size(), columns.size());
  std::set<std::string> answered;
  for (const RankedAnswers::Answer& answer : answers.answers) {
    const ClassifiedModels::Known& known = classified.at(answer.query);
    const std::string query = canonical_model_id(answer.query);
    if (!answered.insert(query).second) {
      throw InputError(fmt::format("the query {} occurs under two spellings", quoted_word(answer.query)));
    }
    const auto own = columns.find(query);
    const auto row = static_cast<Eigen::Index>(input.query_ids.size());
    input.query_ids.push_back(answer.query);
    input.task.query_classes.push_back(known.query ? known.label : no_class);
    input.task.own_column.push_back(own == columns.end() ? -1 : own->second);
    for (const auto& [model, distance] : answer.models) {
      if (!classified.at(model).target) {
        throw InputError(fmt::format("the answer to {} has the model {}, which is no target", quoted_word(answer.query),
                                     quoted_word(model)));
      }
    }
    set_row(answer, columns, canonical_model_id, row, input.distances);
  }
  const auto missing = static_cast<std::size_t>(std::ranges::count_if(
      classified.labels().queries, [&](const std::string& id) { return !answered.contains(canonical_model_id(id)); }));
  note_missing(missing, "queries have no answer", input);
  return input;
}

EvaluationInput input_of_answers(const RankedAnswers& answers, const Judgements& judgements) {
  EvaluationInput input;
  Columns columns;
  for (const auto& answer : answers.answers) {
    for (const auto& [model, distance] : answer.models) columns.emplace(model, 0);
  }
  for (const auto& judged : judgements.queries) {
    for (const std::string& model : judged.relevant) columns.emplace(model, 0);
  }
  number(columns);
  std::unordered_map<std::string, const Judgements::Judged*> judged_queries;
  for (const Judgements::Judged& judged : judgements.queries) judged_queries.emplace(judged.query, &judged);
  input.task.target_classes.assign(columns.size(), 0);
  input.task.lists_may_end_early = true;
  input.distances = nothing_found(answers.answers.size(), columns.size());
  std::size_t unjudged = 0;
  for (const RankedAnswers::Answer& answer : answers.answers) {
    const auto judged = judged_queries.find(answer.query);
    if (judged == judged_queries.end()) {
      ++unjudged;
      continue;
    }
    std::vector<Eigen::Index> relevant;
    for (const std::string& model : judged->second->relevant) relevant.push_back(columns.at(model));
    set_row(answer, columns, std::identity(), static_cast<Eigen::Index>(input.query_ids.size()), input.distances);
    add_judged_query(answer.query, std::move(relevant), -1, input);
  }
  const std::size_t used = input.query_ids.size();
  input.distances.conservativeResize(static_cast<Eigen::Index>(used), Eigen::NoChange);
  note_missing(unjudged, "queries have no judgements", input);
  note_missing(judgements.queries.size() - used, "judged queries have no answer", input);
  return input;
}

EvaluationInput input_of_judgements(const MatrixModels& models, const Judgements& judgements,
                                    const std::string& source) {
  const auto places_of = [](const std::vector<std::string>& ids) {
    std::unordered_map<std::string, Eigen::Index> places;
    for (const std::string& id : ids) places.emplace(canonical_model_id(id), static_cast<Eigen::Index>(places.size()));
    return places;
  };
  const auto rows = places_of(models.rows);
  const auto columns = places_of(models.columns);
  const auto place = [&](const std::string& id, const auto& places) {
    const auto found = places.find(canonical_model_id(id));
    if (found != places.end()) return found->second;
    throw InputError(fmt::format("{}: {} is judged but is not in the matrix", source, quoted_word(id)));
  };
  EvaluationInput input;
  input.query_ids = models.rows;
  input.class_names = models.rows;
  input.same_rows_and_columns = models.rows == models.columns;
  input.task.target_classes.assign(models.columns.size(), 0);
  input.task.query_classes.assign(models.rows.size(), no_class);
  input.task.judged.resize(models.rows.size());
  for (const std::string& id : models.rows) {
    const auto own = columns.find(canonical_model_id(id));
    input.task.own_column.push_back(own == columns.end() ? -1 : own->second);
  }
  for (const Judgements::Judged& judged : judgements.queries) {
    const Eigen::Index row = place(judged.query, rows);
    const auto i = static_cast<std::size_t>(row);
    input.task.query_classes[i] = static_cast<int>(row);
    for (const std::string& model : judged.relevant) input.task.judged[i].push_back(place(model, columns));
    std::ranges::sort(input.task.judged[i]);
  }
  return input;
}

}  // namespace shapegauge

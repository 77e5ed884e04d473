#include "shapegauge/experiments/evaluation/evaluation_input.h"

#include <Eigen/Core>
#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/datasets/labels.h"
#include "shapegauge/experiments/files/matrix_files.h"
#include "shapegauge/experiments/files/model_ids.h"
#include "shapegauge/experiments/files/ranked_answers.h"

namespace shapegauge {

/// The models that the rows and columns of a matrix stand for.
struct MatrixModels {
  std::vector<std::string> rows;
  std::vector<std::string> columns;
};

/// Labels, to be looked up by model; ids are compared as canonical_model_id has it.
class ClassifiedModels {
 public:
  explicit ClassifiedModels(const ModelLabels& labels);

  /// What is known of a model.
  struct Known {
    int label = 0;  ///< index of its class
    bool query = false;
    bool target = false;
  };

  /// Throws InputError where the model is in no class.
  [[nodiscard]] const Known& at(const std::string& id) const;

  /// The models of a matrix that does not name them, in natural order or that of the labels. Where query and target set
  /// differ: queries by targets where the matrix is of that size, else all by all.
  [[nodiscard]] MatrixModels usual_models(Eigen::Index rows, Eigen::Index columns, bool labels_order) const;

  /// The task of a matrix of those models, without its distances. Throws InputError: a model in no class, twice among
  /// the rows or the columns, a query that has no row, a target that has no column.
  [[nodiscard]] EvaluationInput input_of(const MatrixModels& models) const;

  [[nodiscard]] const ModelLabels& labels() const { return labels_; }

 private:
  ModelLabels labels_;
  std::unordered_map<std::string, Known> known_;
};

/// Ranked answers as an evaluation: a row a query, a column a model, in descending order of their ids, which is how
/// trec_eval breaks ties; NaN where an answer does not have the model. With classes, queries without an answer are left
/// out, with a note. Throws InputError where a model is in no class or a query is none.
EvaluationInput input_of_answers(const RankedAnswers& answers, const ClassifiedModels& classified);

/// The same with judgements: a query's relevant models are those that are judged so, found or not. A query is never
/// taken for one of the models. Queries without judgements and judged queries without an answer are left out, with a
/// note.
EvaluationInput input_of_answers(const RankedAnswers& answers, const Judgements& judgements);

/// The task of a matrix of those models under judgements, without its distances. A row's own column is the model of its
/// id, where there is one. Throws InputError where a judged query or model is not in the matrix; `source` names the
/// judgements.
EvaluationInput input_of_judgements(const MatrixModels& models, const Judgements& judgements,
                                    const std::string& source);

namespace {

using Places = std::unordered_map<std::string, Eigen::Index>;

Places places_of(const std::vector<std::string>& ids, const std::string& source) {
  Places places;
  for (const std::string& id : ids) {
    if (places.emplace(canonical_model_id(id), static_cast<Eigen::Index>(places.size())).second) continue;
    throw InputError(fmt::format("model {} occurs twice among the models to look up in {}", quoted_word(id), source));
  }
  return places;
}

void check_all_there(const std::vector<std::string>& wanted, const Places& places, const std::string& source) {
  for (const std::string& id : wanted) {
    if (places.contains(canonical_model_id(id))) continue;
    throw InputError(fmt::format("{}: model {} is classified but is not among the {} models that are there", source,
                                 quoted_word(id), places.size()));
  }
}

}  // namespace

ClassifiedModels::ClassifiedModels(const ModelLabels& labels) : labels_(labels) {
  for (std::size_t i = 0; i < labels.classification.classes.size(); ++i) {
    for (const std::string& model : labels.classification.classes[i].models) {
      known_[canonical_model_id(model)].label = static_cast<int>(i);
    }
  }
  for (const std::string& model : labels.queries) known_.at(canonical_model_id(model)).query = true;
  for (const std::string& model : labels.targets) known_.at(canonical_model_id(model)).target = true;
}

const ClassifiedModels::Known& ClassifiedModels::at(const std::string& id) const {
  const auto found = known_.find(canonical_model_id(id));
  if (found != known_.end()) return found->second;
  throw InputError(fmt::format("{}: model {} is in no class; add it to the file or leave the model out", labels_.source,
                               quoted_word(id)));
}

MatrixModels ClassifiedModels::usual_models(Eigen::Index rows, Eigen::Index columns, bool labels_order) const {
  MatrixModels models{.rows = labels_.queries, .columns = labels_.targets};
  const bool two_sets = static_cast<std::size_t>(rows) == models.rows.size() &&
                        static_cast<std::size_t>(columns) == models.columns.size();
  if (!two_sets) models.rows = models.columns = models_in_file_order(labels_.classification);
  if (!labels_order) {
    std::ranges::sort(models.rows, natural_less);
    std::ranges::sort(models.columns, natural_less);
  }
  return models;
}

EvaluationInput ClassifiedModels::input_of(const MatrixModels& models) const {
  const Places rows = places_of(models.rows, labels_.source);
  const Places columns = places_of(models.columns, labels_.source);
  EvaluationInput input;
  input.query_ids = models.rows;
  input.same_rows_and_columns = rows == columns;
  for (const ModelClass& model_class : labels_.classification.classes) input.class_names.push_back(model_class.name);
  for (const std::string& id : models.rows) {
    const Known& known = at(id);
    input.task.query_classes.push_back(known.query ? known.label : no_class);
    const auto own = columns.find(canonical_model_id(id));
    input.task.own_column.push_back(own == columns.end() ? -1 : own->second);
  }
  for (const std::string& id : models.columns) {
    const Known& known = at(id);
    input.task.target_classes.push_back(known.target ? known.label : no_class);
  }
  check_all_there(labels_.queries, rows, labels_.source);
  check_all_there(labels_.targets, columns, labels_.source);
  return input;
}

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

namespace {

namespace fs = std::filesystem;

/// The ids in a file, one a line; empty lines do not count.
std::vector<std::string> read_ids(const fs::path& path) {
  const std::string text = read_file_bytes(path);
  std::vector<std::string> ids;
  for (const std::string_view line : split_lines(text)) {
    const std::string_view id = trim(line);
    if (!id.empty()) ids.emplace_back(id);
  }
  return ids;
}

// Distances or features, with row ids and column ids where the file has them.
struct ReadTable {
  DistanceMatrix distances{};
  std::optional<ComparedFeatures> features{};
  std::vector<std::string> row_ids;
  std::vector<std::string> column_ids;

  [[nodiscard]] Eigen::Index rows() const { return features ? features->features.rows() : distances.rows(); }
  [[nodiscard]] Eigen::Index columns() const { return features ? features->features.rows() : distances.cols(); }
};

ReadTable read_features(const EvaluationFiles& files) {
  LabelledTable table = read_number_table(files.matrix);
  Signatures features = table.numbers.cast<float>();
  ReadTable read{.row_ids = table.row_ids, .column_ids = table.row_ids};
  try {
    if (files.whole_matrix) {
      read.distances = distance_matrix(features, files.distance);
    } else {
      distance_rows(features, 0, 0, files.distance);  // none, but throws now where rows would later
      read.features = {.features = std::move(features), .distance = files.distance};
    }
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}", files.matrix.string(), error.what()));
  }
  return read;
}

ReadTable read_table(const EvaluationFiles& files, bool must_be_square) {
  if (!files.distance.empty()) return read_features(files);
  ReadTable read;
  if (must_be_square) {
    LabelledDistances square = read_distance_matrix(files.matrix);
    read = {.distances = std::move(square.distances), .row_ids = square.ids, .column_ids = square.ids};
  } else {
    LabelledTable table = read_number_table(files.matrix);
    read = {.distances = std::move(table.numbers), .row_ids = table.row_ids, .column_ids = table.column_ids};
  }
  if (files.similarity) read.distances *= -1;
  return read;
}

void check_size(const ReadTable& table, const MatrixModels& models, const std::string& who,
                const EvaluationFiles& files) {
  if (static_cast<std::size_t>(table.rows()) != models.rows.size()) {
    throw InputError(fmt::format("{} has {} rows, but there are {} models in {}", files.matrix.string(), table.rows(),
                                 models.rows.size(), who));
  }
  if (static_cast<std::size_t>(table.columns()) != models.columns.size()) {
    throw InputError(fmt::format("{} has {} columns, but there are {} models in {}", files.matrix.string(),
                                 table.columns(), models.columns.size(), who));
  }
}

void move_distances(ReadTable& table, EvaluationInput& input) {
  input.distances = std::move(table.distances);
  input.features = std::move(table.features);
}

// The models of the rows and columns as the files say them; nothing where they do not.
MatrixModels models_of_files(const ReadTable& table, const EvaluationFiles& files) {
  const bool square = table.rows() == table.columns();
  MatrixModels models{.rows = table.row_ids, .columns = table.column_ids};
  if (!files.ids.empty()) {
    models.rows = read_ids(files.ids);
    if (square) models.columns = models.rows;
  }
  if (models.rows.empty() || models.columns.empty()) return {};
  return models;
}

EvaluationInput labelled_input(const EvaluationFiles& files) {
  const ModelLabels labels = files.targets.empty()
                                 ? read_labels(files.labels, files.level)
                                 : read_query_and_target_labels(files.labels, files.targets, files.level);
  const ClassifiedModels classified(labels);
  if (is_ranked_answers_file(files.matrix)) return input_of_answers(read_ranked_answers(files.matrix), classified);
  ReadTable table = read_table(files, !labels.separate_sets);
  MatrixModels models = models_of_files(table, files);
  const bool named = !models.rows.empty();
  if (!named) {
    models = classified.usual_models(table.rows(), table.columns(), files.classification_order);
  }
  check_size(table, models, named && !files.ids.empty() ? files.ids.string() : labels.source, files);
  EvaluationInput input = classified.input_of(models);
  move_distances(table, input);
  return input;
}

EvaluationInput judged_input(const EvaluationFiles& files) {
  const Judgements judgements = parse_qrels(read_file_bytes(files.qrels), files.qrels.string());
  EvaluationInput input;
  if (is_ranked_answers_file(files.matrix)) {
    input = input_of_answers(read_ranked_answers(files.matrix), judgements);
  } else {
    ReadTable table = read_table(files, false);
    const MatrixModels models = models_of_files(table, files);
    if (models.rows.empty()) {
      throw InputError(
          fmt::format("{}: with judgements (qrels) the rows and columns need ids: a CSV with ids, or --ids",
                      files.matrix.string()));
    }
    check_size(table, models, files.ids.empty() ? files.matrix.string() : files.ids.string(), files);
    input = input_of_judgements(models, judgements, files.qrels.string());
    move_distances(table, input);
  }
  if (judgements.graded) {
    input.notes.emplace_back("the judgements have grades above 1; every grade above 0 counts as relevant alike");
  }
  return input;
}

}  // namespace

EvaluationInput read_evaluation_input(const EvaluationFiles& files) {
  if (files.labels.empty() == files.qrels.empty()) {
    throw InputError("give either --labels (classes of the models) or --qrels (judgements), and one of them only");
  }
  return files.qrels.empty() ? labelled_input(files) : judged_input(files);
}

}  // namespace shapegauge

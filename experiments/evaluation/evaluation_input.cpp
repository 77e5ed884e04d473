#include "shapegauge/experiments/evaluation/evaluation_input.h"

#include <fmt/format.h>
#include <optional>
#include <stdexcept>
#include <utility>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/experiments/evaluation/answers_input.h"
#include "shapegauge/experiments/evaluation/labelled_task.h"
#include "shapegauge/experiments/evaluation/model_labels.h"
#include "shapegauge/experiments/evaluation/ranked_answers.h"
#include "shapegauge/experiments/matrices/distance_matrix_file.h"
#include "shapegauge/experiments/text/lines.h"

namespace shapegauge {
namespace {

namespace fs = std::filesystem;

/// The ids in a file, one a line; empty lines do not count.
std::vector<std::string> read_ids(const fs::path& path) {
  const std::string text = read_file_bytes(path);
  std::vector<std::string> ids;
  for (const std::string_view line : split_lines(text)) {
    const std::string_view id = without_outer_blanks(line);
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

#include "shapegauge/experiments/evaluation/evaluation_input.h"

#include <fmt/format.h>
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

// Distances between features, or the matrix of the file itself; row ids and column ids where the file has them.
LabelledTable read_distances(const EvaluationFiles& files, bool must_be_square) {
  if (!files.distance.empty()) {
    const LabelledTable features = read_number_table(files.matrix);
    try {
      return {.numbers = distance_matrix(features.numbers.cast<float>(), files.distance),
              .row_ids = features.row_ids,
              .column_ids = features.row_ids};
    } catch (const std::invalid_argument& error) {
      throw InputError(fmt::format("{}: {}", files.matrix.string(), error.what()));
    }
  }
  LabelledTable table;
  if (must_be_square) {
    LabelledDistances square = read_distance_matrix(files.matrix);
    table = {.numbers = std::move(square.distances), .row_ids = square.ids, .column_ids = square.ids};
  } else {
    table = read_number_table(files.matrix);
  }
  if (files.similarity) table.numbers *= -1;
  return table;
}

void check_size(const LabelledTable& table, const MatrixModels& models, const std::string& who,
                const EvaluationFiles& files) {
  if (static_cast<std::size_t>(table.numbers.rows()) != models.rows.size()) {
    throw InputError(fmt::format("{} has {} rows, but there are {} models in {}", files.matrix.string(),
                                 table.numbers.rows(), models.rows.size(), who));
  }
  if (static_cast<std::size_t>(table.numbers.cols()) != models.columns.size()) {
    throw InputError(fmt::format("{} has {} columns, but there are {} models in {}", files.matrix.string(),
                                 table.numbers.cols(), models.columns.size(), who));
  }
}

// The models of the rows and columns as the files say them; nothing where they do not.
MatrixModels models_of_files(const LabelledTable& table, const EvaluationFiles& files) {
  const bool square = table.numbers.rows() == table.numbers.cols();
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
  LabelledTable table = read_distances(files, !labels.separate_sets);
  MatrixModels models = models_of_files(table, files);
  const bool named = !models.rows.empty();
  if (!named) {
    models = classified.usual_models(table.numbers.rows(), table.numbers.cols(), files.classification_order);
  }
  check_size(table, models, named && !files.ids.empty() ? files.ids.string() : labels.source, files);
  EvaluationInput input = classified.input_of(models);
  input.distances = std::move(table.numbers);
  return input;
}

EvaluationInput judged_input(const EvaluationFiles& files) {
  const Judgements judgements = parse_qrels(read_file_bytes(files.qrels), files.qrels.string());
  EvaluationInput input;
  if (is_ranked_answers_file(files.matrix)) {
    input = input_of_answers(read_ranked_answers(files.matrix), judgements);
  } else {
    LabelledTable table = read_distances(files, false);
    const MatrixModels models = models_of_files(table, files);
    if (models.rows.empty()) {
      throw InputError(
          fmt::format("{}: with judgements (qrels) the rows and columns need ids: a CSV with ids, or --ids",
                      files.matrix.string()));
    }
    check_size(table, models, files.ids.empty() ? files.matrix.string() : files.ids.string(), files);
    input = input_of_judgements(models, judgements, files.qrels.string());
    input.distances = std::move(table.numbers);
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

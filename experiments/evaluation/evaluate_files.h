#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/datasets/files/open_matrix.h"
#include "shapegauge/experiments/evaluation/evaluation_task.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/matrix_checks.h"

namespace shapegauge {

/// Files of an evaluation and their interpretation.
struct EvaluationFiles {
  std::filesystem::path matrix;     ///< distances, similarities, features, a TREC run or ranked lists
  std::string variable{};           ///< of an .npz or .mat file with several arrays; may be empty
  std::filesystem::path labels{};   ///< see read_labels(); empty with judgements
  std::filesystem::path targets{};  ///< labels of the targets if `labels` are those of the queries; may be empty
  std::filesystem::path qrels{};    ///< TREC judgements instead of labels; may be empty
  std::filesystem::path
      ids{};  ///< ids of the rows, one per line, equal to those of the matrix if it has any; may be empty
  RowOrder order = RowOrder::usual;              ///< of rows without ids
  Unanswered unanswered = Unanswered::left_out;  ///< handling of queries without a ranked list
  std::size_t level = 0;                         ///< level of the class hierarchy, see read_labels()
  bool shared_ids = false;                       ///< an id in `labels` and `targets` is one model, not two
  bool similarity = false;                       ///< larger values are nearer
  std::string distance{};  ///< distance between features, if the matrix has features, a row a model; may be empty
};

/// File of a run with the ids of the models, one per line, beside its matrices (.npy) of distances and of features.
/// Evaluations use it unless `ids` or `order` is given.
inline constexpr std::string_view stored_ids_name = "ids.txt";

/// Reads the labels that the files name: of one set of models, or of queries and targets.
TaskLabels read_task_labels(const EvaluationFiles& files);

/// Distances or ranked answers with their interpretation.
struct EvaluationData {
  OpenMatrix distances;
  RankedAnswerLists answers{};  ///< instead of distances if the task has a coverage
  bool symmetric = false;       ///< by construction
  std::string name{};           ///< tag of a TREC run; may be empty
  EvaluationTask task;
};

/// Returns warnings about a matrix, one sentence each. `ids` name its rows; `negated` means that it contained
/// similarities.
std::vector<std::string> matrix_warnings(const MatrixFindings& found, std::span<const std::string> ids, bool negated);

/// Returns warnings about a matrix to be re-ranked, one sentence each. Reads it once more.
std::vector<std::string> rerank_warnings(const OpenMatrix& matrix);

/// Returns the warning about queries with relevant and other models at equal distance, with the effect of their order
/// on FT. Nothing if all these queries are rows of equal distances, which matrix_warnings() reports.
std::optional<std::string> ties_warning(const Evaluation& evaluation, const MatrixFindings& found);

/// Returns the warning about fewer relevant nearest neighbours than a random order has, which rows in the wrong order
/// or similarities read as distances may cause. For matrices only: lists may lack models.
std::optional<std::string> chance_warning(const Evaluation& evaluation, const MatrixFindings& found,
                                          const RetrievalTask& task);

/// Returns the warning about models that are never queries because their classes are small, if there are any.
std::optional<std::string> left_out_warning(const Evaluation& evaluation, const RetrievalTask& task,
                                            const EvaluationOptions& options);

/// Reads and matches the files. Distances between features, and those of large binary files, are neither computed nor
/// read yet. Throws InputError if a file cannot be read or files do not match: a matrix of another size than the
/// labels, a model without a class, a classified model that is not in the matrix, a repeated id, other ids than the
/// matrix has, features outside the distance's domain.
EvaluationData open_evaluation_files(const EvaluationFiles& files);

/// Evaluated files with their results.
struct EvaluatedFiles {
  EvaluationData data;
  Evaluation evaluation;
  MatrixFindings findings;            ///< of the matrix; empty for ranked lists
  std::vector<std::string> warnings;  ///< one sentence each
};

/// Receives the number of evaluated rows of a matrix.
using RowProgress = std::function<void(Eigen::Index done, Eigen::Index rows)>;

/// Opens the files, evaluates their distances in blocks of rows and checks them for anomalies. Memory grows linearly
/// with the number of models, unless the file can only be read as a whole. Throws InputError as open_evaluation_files()
/// does, and if nothing can be evaluated.
EvaluatedFiles evaluate_files(const EvaluationFiles& files, const EvaluationOptions& options,
                              const RowProgress& progress = {});

}  // namespace shapegauge

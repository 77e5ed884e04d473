// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
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
  std::string distance{};  ///< distance between features, if the matrix has features, one row per model; may be empty
};

/// File of a run with the ids of the models, one per line, next to its matrices (.npy) of distances and of features.
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

/// Warning about a file.
struct FileWarning {
  std::string file;
  std::string text;
};

/// Returns each text once, with the name of its file or, for several, with their number and the first of them. `noun`
/// stands for files: "submissions".
std::vector<std::string> merged_warnings(std::span<const FileWarning> warnings, std::string_view noun);

/// Receives the number of evaluated rows of a matrix.
using RowProgress = std::function<void(Eigen::Index done, Eigen::Index rows)>;

/// Opens the files, evaluates their distances in blocks of rows and checks them for anomalies. Memory grows linearly
/// with the number of models, unless the file can only be read as a whole. Throws InputError as open_evaluation_files()
/// does, and if nothing can be evaluated.
EvaluatedFiles evaluate_files(const EvaluationFiles& files, const EvaluationOptions& options,
                              const RowProgress& progress = {});

}  // namespace shapegauge

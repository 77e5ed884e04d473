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

/// Input files of a retrieval evaluation, and settings for reading them.
struct EvaluationFiles {
  std::filesystem::path matrix;     ///< file of distances, similarities, features or ranked lists (TREC run)
  std::string variable{};           ///< name of an array in an .npz or .mat file; empty for its only array
  std::filesystem::path labels{};   ///< file of class labels (read_labels()); empty if `qrels` is set
  std::filesystem::path targets{};  ///< file of target labels; empty if `labels` has queries and targets
  std::filesystem::path qrels{};    ///< file of TREC relevance judgements; empty if `labels` is set
  std::filesystem::path
      ids{};  ///< file with the model ids of the matrix rows, one per line; empty for those of the matrix or of `order`
  RowOrder order = RowOrder::automatic;          ///< order of the rows of a matrix without ids
  Unanswered unanswered = Unanswered::left_out;  ///< handling of queries without a ranked list
  std::size_t level = 0;    ///< level of the class hierarchy to evaluate, 1 for the top; 0: labelled classes
  bool shared_ids = false;  ///< true if equal ids in `labels` and `targets` mean the same model
  bool similarity = false;  ///< true if the matrix has similarities: a larger value means nearer
  std::string distance{};   ///< name of the distance between features, if `matrix` has features; otherwise empty
};

/// Name of the file in which a run stores the ids of the models, one per line, next to its matrices (.npy) of distances
/// and of features. Evaluations use it unless `ids` or `order` is given.
inline constexpr std::string_view stored_ids_name = "ids.txt";

/// Reads the class labels of an evaluation: of one set of models, or of separate queries and targets. Throws InputError
/// as read_labels() does, and for `shared_ids` without `targets`.
TaskLabels read_task_labels(const EvaluationFiles& files);

/// Opened input of an evaluation: distances or ranked answers, with the retrieval task that they belong to.
struct EvaluationData {
  OpenMatrix distances;         ///< distance matrix, read in blocks; empty for ranked answers
  RankedAnswerLists answers{};  ///< ranked lists, if task.coverage is set; empty for a matrix
  bool symmetric = false;       ///< true if distances are symmetric by construction, as between features
  std::string name{};           ///< tag of a TREC run, which names the method; empty for other files
  EvaluationTask task;          ///< retrieval task: which models are relevant to which queries
};

/// Opens the files and matches the models of the matrix with the labels or judgements. Distances between features, and
/// those of large binary files, are neither computed nor read yet. Throws InputError if a file cannot be read or files
/// do not match: a matrix of another size than the labels, a model without a class, a classified model that is not in
/// the matrix, a repeated id, ids that differ from those in the matrix, features outside the domain of the distance.
EvaluationData open_evaluation_files(const EvaluationFiles& files);

/// Result of evaluate_files(): the input with its scores and warnings.
struct EvaluatedFiles {
  EvaluationData data;                ///< evaluated input
  Evaluation evaluation;              ///< scores of the input
  MatrixFindings findings;            ///< anomalies found in the matrix; default values for ranked lists
  std::vector<std::string> warnings;  ///< warnings about the files and scores, one sentence each
};

/// Warning with the name of the file that it is about.
struct FileWarning {
  std::string file;  ///< name of the file
  std::string text;  ///< warning in one sentence
};

/// Merges equal warnings: returns each distinct text once, after the name of its file or, for several files, after
/// their number and the name of the first one. `noun` is the plural noun for the files, such as "submissions".
std::vector<std::string> merged_warnings(std::span<const FileWarning> warnings, std::string_view noun);

/// Progress callback: receives the numbers of evaluated rows and of all rows of a matrix.
using RowProgress = std::function<void(Eigen::Index done, Eigen::Index rows)>;

/// Opens the files, evaluates the distances in blocks of rows (or the ranked lists) and checks a matrix for anomalies.
/// Memory grows linearly with the number of models, unless the format of the matrix requires reading it as a whole.
/// Throws InputError as open_evaluation_files() does, and if nothing can be evaluated.
EvaluatedFiles evaluate_files(const EvaluationFiles& files, const EvaluationOptions& options,
                              const RowProgress& progress = {});

}  // namespace shapegauge

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/base/setting_names.h"
#include "shapegauge/datasets/files/open_matrix.h"
#include "shapegauge/experiments/evaluation/evaluation_task.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/matrix_checks.h"

namespace shapegauge {

/// The files of an evaluation, and how they are to be taken.
struct EvaluationFiles {
  std::filesystem::path matrix;      ///< distances, similarities, features, a TREC run or ranked lists
  std::filesystem::path labels{};    ///< see read_labels; empty where there are judgements
  std::filesystem::path targets{};   ///< labels of the targets, where `labels` has the queries' only; may be empty
  std::filesystem::path qrels{};     ///< TREC judgements in place of labels; may be empty
  std::filesystem::path ids{};       ///< ids of the rows, one a line; may be empty
  RowOrder order = RowOrder::usual;  ///< of rows without ids
  Unanswered unanswered = Unanswered::left_out;  ///< queries without a ranked list
  std::size_t level = 0;                         ///< of the hierarchy of classes, see read_labels
  bool similarity = false;                       ///< larger is nearer
  std::string distance{};  ///< the matrix holds features, a row a model: the distance to take; may be empty
};

/// Distances, and what they mean.
struct EvaluationData {
  OpenMatrix distances;
  bool symmetric = false;  ///< by the way the distances are made
  std::string name{};      ///< that a TREC run gives itself; may be empty
  EvaluationTask task;
};

/// Describes how many pairs of entries of an asymmetric matrix differ, and by how much.
std::string asymmetry_text(const MatrixFindings& found);

/// What a user should know of a matrix, a sentence each. `ids` name its rows; `negated`: it was of similarities.
std::vector<std::string> matrix_warnings(const MatrixFindings& found, std::span<const std::string> ids, bool negated,
                                         Audience audience = Audience::command_line);

/// The warning about queries with relevant and other models at equal distance, and how far their order moves FT.
/// Nothing where all such queries are rows of equal distances, which matrix_warnings() reports.
std::optional<std::string> ties_warning(const Evaluation& evaluation, const MatrixFindings& found,
                                        Audience audience = Audience::command_line);

/// The warning about models that are never queries because their classes are small, if there are any.
std::optional<std::string> left_out_warning(const Evaluation& evaluation, const RetrievalTask& task,
                                            const EvaluationOptions& options);

/// Reads the files and fits them together. Distances between features, and those of large binary files, are not
/// computed or read yet. Throws InputError where a file cannot be read or they do not fit: a matrix of another size
/// than the labels, a model without a class, a classified model that is not in the matrix, an id that occurs twice,
/// features for which the distance is not defined.
EvaluationData open_evaluation_files(const EvaluationFiles& files);

/// Files that were evaluated.
struct EvaluatedFiles {
  EvaluationData data;
  Evaluation evaluation;
  MatrixFindings findings;            ///< of the matrix; empty for ranked lists
  std::vector<std::string> warnings;  ///< what a user should know of the files, a sentence each
};

/// Told how many of a matrix's rows are done.
using RowProgress = std::function<void(Eigen::Index done, Eigen::Index rows)>;

/// Opens the files, evaluates their distances a few hundred rows at a time and looks for what is odd about them: memory
/// grows with the number of models and not with its square, unless the file can be read only as a whole. Throws
/// InputError as open_evaluation_files, and where nothing can be evaluated.
EvaluatedFiles evaluate_files(const EvaluationFiles& files, const EvaluationOptions& options,
                              const RowProgress& progress = {});

}  // namespace shapegauge

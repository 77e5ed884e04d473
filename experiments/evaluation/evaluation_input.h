#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shapegauge/metrics/retrieval_task.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// The files that an evaluation is made of, and what they hold.
struct EvaluationFiles {
  std::filesystem::path matrix;       ///< distances, similarities, features, a TREC run or ranked lists
  std::filesystem::path labels{};     ///< see read_labels; empty where there are judgements
  std::filesystem::path targets{};    ///< labels of the targets, where `labels` is of the queries only; may be empty
  std::filesystem::path qrels{};      ///< TREC judgements in place of labels; may be empty
  std::filesystem::path ids{};        ///< ids of the rows, one a line; may be empty
  bool classification_order = false;  ///< rows without ids are in the labels' order, else in natural order
  std::size_t level = 0;              ///< of the hierarchy of classes, see read_labels
  bool similarity = false;            ///< larger is nearer
  std::string distance{};             ///< the matrix holds features, a row a model: the distance to take; may be empty
  bool whole_matrix = false;          ///< distances between features are computed at once, for who needs all of them
};

/// Features, a row a model, and the distance to take between them. distance_rows takes them.
struct ComparedFeatures {
  Signatures features;
  std::string distance;
};

/// Distances, and what their rows and columns mean.
struct EvaluationInput {
  DistanceMatrix distances;                  ///< none where there are features
  std::optional<ComparedFeatures> features;  ///< in place of the distances of all models to all
  RetrievalTask task;
  std::vector<std::string> query_ids;    ///< by row
  std::vector<std::string> class_names;  ///< by class in the task
  bool same_rows_and_columns = false;    ///< row i and column i are the same model
  std::vector<std::string> notes;        ///< what a user should know of how the files were taken, in words
};

/// Reads the files of an evaluation and fits them together. Throws InputError where one cannot be read or they do not
/// fit: a matrix of another size than the labels, a model without a class, a classified model that is not in the
/// matrix, an id that occurs twice, features for which the distance is not defined.
EvaluationInput read_evaluation_input(const EvaluationFiles& files);

}  // namespace shapegauge

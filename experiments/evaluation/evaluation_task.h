#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "shapegauge/datasets/files/ranked_answers.h"
#include "shapegauge/datasets/layouts/labels.h"
#include "shapegauge/metrics/retrieval_task.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// The ids of the rows and columns of a matrix; both empty where it does not name them.
struct MatrixIds {
  std::vector<std::string> rows;
  std::vector<std::string> columns;
};

/// The size of a matrix.
struct MatrixSize {
  Eigen::Index rows = 0;
  Eigen::Index columns = 0;
};

/// Coverage of ranked lists: the number of queries and the lengths of lists that scores are based on.
struct ListCoverage {
  std::size_t queries = 0;     ///< labelled or judged queries
  std::size_t answered = 0;    ///< queries with a list, among them
  Eigen::Index shortest = 0;   ///< models in a list, the query itself left out
  Eigen::Index longest = 0;    ///< as above
  std::size_t incomplete = 0;  ///< lists with fewer models than are relevant: even their best order scores below 1
};

/// What the rows and columns of a matrix mean, with the names that people read.
struct EvaluationTask {
  RetrievalTask retrieval;
  std::vector<std::string> query_ids;      ///< by row
  std::vector<std::string> class_names;    ///< by class in the retrieval task
  bool same_rows_and_columns = false;      ///< row i and column i are the same model
  std::optional<ListCoverage> coverage{};  ///< of ranked lists; a matrix covers all
  std::vector<std::string> warnings;       ///< how the files were taken, where a user might expect otherwise
};

/// Which model a row is where no ids say so: the i-th in natural order (2 before 10), or in that of the labels' file.
/// usual: that of the file where it is a list (ModelLabels::listed), else natural.
enum class RowOrder { usual, natural, file };

/// Whether queries that are in the labels or judgements but have no answer count, with an answer that finds nothing.
enum class Unanswered { left_out, count };

/// The models of a matrix without ids: the i-th row is the i-th labelled model, in that order. Where queries and
/// targets are separate sets: queries by targets if the matrix has that size, else all models by all models.
MatrixIds labelled_ids(const ModelLabels& labels, const MatrixSize& size, RowOrder order);

/// The task of a matrix of these models under labels. Ids are compared as canonical_model_id has it. Throws InputError:
/// a model in no class, a model twice among the rows or the columns, a query without a row, a target without a column.
EvaluationTask task_of_labels(const MatrixIds& ids, const ModelLabels& labels);

/// The task of a matrix of these models under judgements. A row's own column is that of the same id, if there is one.
/// Throws InputError where a judged query or model is not in the matrix; `source` names the judgements.
EvaluationTask task_of_judgements(const MatrixIds& ids, const Judgements& judgements, const std::string& source);

/// Ranked answers as a matrix: a row a query, a column a model, NaN where an answer does not have the model. Columns
/// are in descending order of their ids, which is how trec_eval breaks ties.
struct RankedTask {
  DistanceMatrix distances;
  EvaluationTask task;
};

/// Ranked answers under labels. Labelled queries without an answer are told in a warning. Throws InputError where a
/// model is in no class, a query has two spellings, or an answer has a model that is no target.
RankedTask task_of_answers(const RankedAnswers& answers, const ModelLabels& labels, Unanswered unanswered);

/// Ranked answers under judgements: what is relevant counts whether found or not, and a query is never one of the
/// models. Queries without judgements are left out; they and judged queries without an answer are told in a warning.
RankedTask task_of_answers(const RankedAnswers& answers, const Judgements& judgements, Unanswered unanswered);

/// Whether a report (pages/report.h) can show the task: its models are all queries to all others, each has a class, and
/// answers do not end early.
bool is_fit_for_report(const EvaluationTask& task);

}  // namespace shapegauge

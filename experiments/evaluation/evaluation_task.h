// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/words.h"
#include "shapegauge/datasets/files/ranked_answers.h"
#include "shapegauge/datasets/layouts/labels.h"
#include "shapegauge/metrics/ranked_list.h"
#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// Model ids of the rows and columns of a matrix; both lists are empty for a matrix without ids.
struct MatrixIds {
  std::vector<std::string> rows;     ///< ids of the models in the rows (queries)
  std::vector<std::string> columns;  ///< ids of the models in the columns (targets)
};

/// Numbers of rows and columns of a matrix.
struct MatrixSize {
  Eigen::Index rows = 0;     ///< number of rows (queries)
  Eigen::Index columns = 0;  ///< number of columns (targets)
};

/// Coverage of ranked lists: the number of queries and the lengths of lists that scores are based on.
struct ListCoverage {
  std::size_t queries = 0;     ///< number of labelled or judged queries
  std::size_t answered = 0;    ///< number of labelled or judged queries with a ranked list
  Eigen::Index shortest = 0;   ///< smallest number of models in a ranked list, not counting the query itself
  Eigen::Index longest = 0;    ///< largest number of models in a ranked list, not counting the query itself
  std::size_t incomplete = 0;  ///< number of ranked lists shorter than the number of relevant models
};

/// Retrieval task of an evaluation (which models are relevant to which queries), with the names of queries and classes.
struct EvaluationTask {
  RetrievalTask retrieval;                 ///< class or relevant models of each query (row), and class of each target
  std::vector<std::string> query_ids;      ///< ids of the models in the rows of the matrix, or of ranked lists
  std::vector<std::string> class_names{};  ///< name of each class; with relevance judgements, the query ids
  bool same_rows_and_columns = false;      ///< true if row i and column i are the same model for each i
  std::optional<ListCoverage> coverage{};  ///< coverage of ranked lists; absent for a matrix, which has all models
  std::vector<std::string> warnings{};     ///< warnings about the interpretation of the files, one sentence each
};

/// Assumed order of the rows of a matrix without ids: natural order of the ids in the labels file (2 before 10), or the
/// order of that file. `automatic`: file order if the labels are a list (ModelLabels::listed), otherwise natural order.
enum class RowOrder { automatic, natural, file };

/// Handling of labelled or judged queries without a ranked list: left out of the averages, or counted with scores of 0.
enum class Unanswered { left_out, count };
template <>
inline constexpr std::array<std::string_view, 2> words_of<Unanswered>{"skip", "zero"};

/// Returns the ids assumed for a matrix without ids: row i is the i-th labelled model in `order`. The matrix is
/// queries by targets if it has that size or if the targets have labels of their own; otherwise all models by all
/// models.
MatrixIds labelled_ids(const TaskLabels& labels, const MatrixSize& size, RowOrder order);

/// Makes the retrieval task of a distance matrix from class labels; `ids` are the models of its rows and columns.
/// Compares ids by ModelKeys. Throws InputError for a model without class, a repeated model of the rows or columns, a
/// query without a row, and a target without a column.
EvaluationTask task_of_labels(const MatrixIds& ids, const TaskLabels& labels);

/// Makes the retrieval task of a distance matrix from relevance judgements; `ids` are the models of its rows and
/// columns. A query's own column is the one with the same id, if any. `source` names the judgements in messages. Throws
/// InputError if a judged query or model is not in the matrix.
EvaluationTask task_of_judgements(const MatrixIds& ids, const Judgements& judgements, const std::string& source);

/// Ranked lists of retrieved models, one per query, with their retrieval task. The columns of the task are in
/// descending order of model ids, the order in which trec_eval breaks ties.
struct RankedTask {
  RankedAnswerLists answers;  ///< ranked list of each query of the task; an empty list for a query without one
  EvaluationTask task;        ///< retrieval task of the lists, with one row per list
};

/// Makes the retrieval task of ranked answers from class labels. Warns of labelled queries without an answer. Throws
/// InputError for a model without class, a repeated query, and an answer with a model that is repeated or not a target.
RankedTask task_of_answers(const RankedAnswers& answers, const TaskLabels& labels, Unanswered unanswered);

/// Makes the retrieval task of ranked answers from relevance judgements: all relevant models count, found or not. A
/// model with the id of the query is not excluded. Ignores answers to queries without judgements. Warns of these
/// queries and of judged queries without an answer.
RankedTask task_of_answers(const RankedAnswers& answers, const Judgements& judgements, Unanswered unanswered);

/// Returns true if a report page (pages/report.h) can show the task: rows and columns of a matrix (not ranked lists)
/// are the same models, and each has a class label (no relevance judgements).
bool is_fit_for_report(const EvaluationTask& task);

}  // namespace shapegauge

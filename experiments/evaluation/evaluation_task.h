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

/// Ids of the rows and columns of a matrix; both empty if it has none.
struct MatrixIds {
  std::vector<std::string> rows;
  std::vector<std::string> columns;
};

/// Size of a matrix.
struct MatrixSize {
  Eigen::Index rows = 0;
  Eigen::Index columns = 0;
};

/// Coverage of ranked lists: the number of queries and the lengths of lists that scores are based on.
struct ListCoverage {
  std::size_t queries = 0;     ///< labelled or judged queries
  std::size_t answered = 0;    ///< queries with a list, among them
  Eigen::Index shortest = 0;   ///< models in a list, the query itself left out
  Eigen::Index longest = 0;    ///< likewise
  std::size_t incomplete = 0;  ///< lists with fewer models than are relevant: even their best order scores below 1
};

/// One task of retrieval, whatever files it comes from, with names for readers.
struct EvaluationTask {
  RetrievalTask retrieval;
  std::vector<std::string> query_ids;      ///< per row
  std::vector<std::string> class_names{};  ///< per class in the retrieval task
  bool same_rows_and_columns = false;      ///< row i and column i are the same model
  std::optional<ListCoverage> coverage{};  ///< of ranked lists; a matrix covers all
  std::vector<std::string> warnings{};     ///< remarks on how the files were interpreted
};

/// Order of rows without ids: natural order of the labels' ids (2 before 10), or that of the labels' file. `usual`:
/// that of the file if it is a list (ModelLabels::listed), otherwise natural.
enum class RowOrder { usual, natural, file };

/// Handling of labelled or judged queries without an answer: ignored, or counted with empty answers.
enum class Unanswered { left_out, count };
template <>
inline constexpr std::array<std::string_view, 2> words_of<Unanswered>{"skip", "zero"};

/// Returns the models of a matrix without ids: the i-th row is the i-th labelled model, in that order. If queries and
/// targets are separate sets: queries by targets if the matrix has that size, otherwise all models by all models.
MatrixIds labelled_ids(const TaskLabels& labels, const MatrixSize& size, RowOrder order);

/// Makes the task of a matrix of these models with labels. Compares ids by ModelKeys. Throws InputError for
/// a model without class, a repeated model of the rows or columns, a query without a row, and a target without a
/// column.
EvaluationTask task_of_labels(const MatrixIds& ids, const TaskLabels& labels);

/// Makes the task of a matrix of these models with judgements. A row's own column is that of the same id, if any.
/// Throws InputError if a judged query or model is not in the matrix; `source` names the judgements.
EvaluationTask task_of_judgements(const MatrixIds& ids, const Judgements& judgements, const std::string& source);

/// Ranked answers with their task. Columns are in descending order of ids, like ties in trec_eval.
struct RankedTask {
  RankedAnswerLists answers;
  EvaluationTask task;
};

/// Makes the task of ranked answers with labels. Warns of labelled queries without an answer. Throws InputError for a
/// model without class, a repeated query, and an answer with a model that is repeated or not a target.
RankedTask task_of_answers(const RankedAnswers& answers, const TaskLabels& labels, Unanswered unanswered);

/// Makes the task of ranked answers with judgements: all relevant models count, found or not, and a query is never one
/// of the models. Ignores queries without judgements; warns of these and of judged queries without an answer.
RankedTask task_of_answers(const RankedAnswers& answers, const Judgements& judgements, Unanswered unanswered);

/// Returns true if a report (pages/report.h) can show the task: all models are queries to all others, each has a class,
/// and lists are complete.
bool is_fit_for_report(const EvaluationTask& task);

}  // namespace shapegauge

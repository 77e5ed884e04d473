// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/base/members.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/metrics/measures.h"
#include "shapegauge/metrics/precision_recall.h"
#include "shapegauge/metrics/protocol.h"
#include "shapegauge/metrics/ranked_list.h"
#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// Options of evaluate(): protocol, ties, measures, precision-recall curve and choice of queries.
struct EvaluationOptions {
  Protocol protocol = Protocol::psb;  ///< whether lists contain the query; default measures and curve
  Ties ties = Ties::index;            ///< order of models at equal distance
  std::vector<Measure> measures{};    ///< measures to compute; default_measures(protocol) if empty
  std::optional<CurveKind> curve{};   ///< kind of precision-recall curve; default_curve(protocol) if not set
  /// Minimum number of models in the class of a query, the query included (psbTable: 3): models of smaller classes are
  /// not queries. A query thus needs minimum_class_size - 1 relevant models. 1: judged queries without a relevant
  /// model count, with scores of 0.
  int minimum_class_size = 2;
  bool finds_itself = false;  ///< true: the query itself is ranked in its list like any other target, not excluded
};

/// Returns the measures that an evaluation computes: options.measures, or the default measures if empty.
std::vector<Measure> evaluated_measures(const EvaluationOptions& options);

/// Returns the cache version of each measure that an evaluation computes, by name; always includes FT.
std::map<std::string, int> measure_versions(const EvaluationOptions& options);

/// Names, bounds and help texts of the members `ties` and `minimum_class_size` of EvaluationOptions.
inline constexpr std::array evaluation_table = {
    option_of<&EvaluationOptions::ties>(
        "ties",
        "Order of models at equal distance. index: lower index first; optimistic: relevant models first; pessimistic: "
        "relevant models last; expected: mean over all orders."),
    option_of<&EvaluationOptions::minimum_class_size>("minimum_class_size", {.low = 1, .high = 1'000'000},
                                                      "Minimum size of a query's class, the query included; models of "
                                                      "smaller classes are only targets. 1: equivalent "
                                                      "to 2; 3: as psbTable of the Princeton Shape Benchmark."),
};

/// Mean first tier (FT) over the queries if, among models at equal distance, relevant ones rank last (pessimistic) or
/// first (optimistic).
struct FirstTierBounds {
  double pessimistic = 0;  ///< mean FT if relevant models rank last among tied models
  double optimistic = 0;   ///< mean FT if relevant models rank first among tied models
};

/// Scores of a distance matrix under one protocol, from 0 to 1 (some definitions of evaluators.h exceed 1). Column j of
/// `per_query` and `per_class`, and entry j of `micro` and `macro`, belong to measures[j].
struct Evaluation {
  Protocol protocol = Protocol::psb;               ///< protocol of the ranked lists
  Ties ties = Ties::index;                         ///< order of models at equal distance
  CurveKind curve = CurveKind::psb;                ///< kind of the precision-recall curves
  std::vector<std::string> measures;               ///< names of the measures: "NN", "FT", "ST", "E", "DCG", "mAP"
  std::vector<Eigen::Index> queries;               ///< matrix row of each query, ascending
  std::vector<int> query_classes;                  ///< class label of each query
  Eigen::MatrixXd per_query;                       ///< scores of single queries: queries x measures
  std::vector<int> classes;                        ///< labels of the classes with queries, ascending
  Eigen::MatrixXd per_class;                       ///< mean scores of the queries of each class: classes x measures
  Eigen::VectorXd micro;                           ///< mean score over queries, per measure
  Eigen::VectorXd macro;                           ///< mean score over the class means, per measure
  PrecisionRecallCurve micro_curve;                ///< precision-recall curve averaged over queries
  PrecisionRecallCurve macro_curve;                ///< precision-recall curve averaged over classes
  std::vector<PrecisionRecallCurve> class_curves;  ///< precision-recall curve of each class in `classes`
  Eigen::Index excluded_models = 0;                ///< number of queries excluded for too few relevant models
  Eigen::Index queries_with_ties = 0;  ///< number of queries with RankedList::tied: the order of ties may matter
  FirstTierBounds first_tier_bounds;   ///< bounds of mean FT for any `measures`; equal if ties have no effect
};

/// References to all members of the results of an evaluation, for serialisation (experiments/cache/codec.h).
/// @{
SHAPEGAUGE_MEMBERS(PrecisionRecallCurve, recall, precision)
SHAPEGAUGE_MEMBERS(FirstTierBounds, pessimistic, optimistic)
SHAPEGAUGE_MEMBERS(Evaluation, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q)
/// @}

/// Evaluates a distance matrix against the classes of the models, with every model as a query to all others
/// (docs/reference/definitions.md#measures). labels[i] is the class of model i. Distances need not be symmetric and may
/// be infinite (ranked_list()); the diagonal is ignored. Models of classes that are too small are not queries, but
/// remain targets. Parallel over queries; the result is bit-identical for any number of threads. Throws ArgumentError
/// for a matrix that is empty, not square or of another size than labels, a distance that is NaN (the message has row
/// and column, counted from 0), a minimum class size out of range, and if no class is large enough.
Evaluation evaluate(const DistanceTable& distances, std::span<const int> labels, const EvaluationOptions& options);

/// Evaluates a distance matrix whose rows and columns are described by a task. Throws ArgumentError if the sizes of
/// matrix and task differ, for a distance that is NaN, a minimum class size out of range, and if there are no queries.
Evaluation evaluate(const DistanceTable& distances, const RetrievalTask& task, const EvaluationOptions& options);

/// Evaluates a distance matrix that does not fit into memory: requests blocks of a few hundred rows sequentially. The
/// result is bit-identical to evaluate() of the whole matrix, with the same exceptions. Throws ArgumentError also for a
/// block of the wrong size.
Evaluation evaluate(const RowSource& distances, const RetrievalTask& task, const EvaluationOptions& options);

/// Evaluates ranked answers, one per row of the task. Memory is proportional to the number of listed models. Throws
/// ArgumentError unless there is one answer per row, for a minimum class size out of range, and if there are no
/// queries.
Evaluation evaluate(const RankedAnswerLists& answers, const RetrievalTask& task, const EvaluationOptions& options);

/// Scores of all queries of a task or of a range of them, in order of matrix rows; filled by RowEvaluator.
struct QueryScores {
  Eigen::MatrixXd measures;           ///< score by each measure: queries x measures
  Eigen::MatrixXd precisions;         ///< precision at each recall level of the curve: queries x recall levels
  std::vector<std::size_t> relevant;  ///< number of relevant models of each query
  std::vector<char> tied;             ///< per query: 1 if the order of ties may matter (RankedList::tied), otherwise 0
  Eigen::MatrixX2d first_tiers;       ///< FT of each query under Ties::pessimistic and Ties::optimistic: queries x 2
};

/// Evaluates all rows of a distance matrix or a range of them, in blocks. Several processes may each evaluate a range;
/// evaluation_of() combines the scores. The task must outlive the object. If EvaluationOptions::finds_itself is set,
/// each own_column of the task must be -1; the functions evaluate() set this themselves.
class RowEvaluator {
 public:
  /// Prepares the evaluation of the matrix rows [first, last). Throws ArgumentError for a task of inconsistent size, a
  /// minimum class size out of range, and if there are no queries.
  RowEvaluator(const RetrievalTask& task, const EvaluationOptions& options, Eigen::Index first, Eigen::Index last);

  /// Evaluates the queries among consecutive rows of the matrix, the first of which is row `first`. Parallel. Throws
  /// ArgumentError for a distance that is NaN.
  void evaluate(const DistanceTable& rows, Eigen::Index first);

  /// Evaluates ranked answers, one for each row of the task. Parallel.
  void evaluate(const RankedAnswerLists& answers);

  /// Returns the scores of the queries among the rows of this evaluator, in order of rows.
  [[nodiscard]] const QueryScores& scores() const { return scores_; }

  /// Averages the scores of all queries of the task, in order of rows, and returns the complete evaluation.
  [[nodiscard]] Evaluation evaluation_of(const QueryScores& all) const;

 private:
  /// Evaluates the queries in rows [first, last); list_of(row, extremes) returns the ranked list of a row.
  template <typename ListOf>
  void evaluate_rows(Eigen::Index first, Eigen::Index last, const ListOf& list_of);
  void keep(std::size_t score, const RankedList& list);  ///< sets row `score` of scores_ from a ranked list

  Relevance relevance_;            ///< relevance of targets to queries
  std::vector<Measure> measures_;  ///< measures to compute, as columns of QueryScores::measures
  Measure first_tier_;             ///< FT, for Evaluation::first_tier_bounds
  Evaluation blank_;               ///< evaluation with its queries and classes, but without scores
  std::size_t largest_ = 0;        ///< largest number of relevant models of a query; under paper, the query included
  std::size_t first_query_ = 0;    ///< index in blank_.queries of the first query of this evaluator
  QueryScores scores_;             ///< scores of the queries among the rows of this evaluator
};

}  // namespace shapegauge

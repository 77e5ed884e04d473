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

/// Options of an evaluation.
struct EvaluationOptions {
  Protocol protocol = Protocol::psb;
  Ties ties = Ties::index;
  std::vector<Measure> measures{};   ///< default_measures(protocol) if empty
  std::optional<CurveKind> curve{};  ///< default_curve(protocol) if not set
  /// Models of smaller classes are not queries. The size includes the query (psbTable: 3). Every query then has at
  /// least one relevant model less, whether or not it is itself a target. 1: judged queries without a relevant model
  /// count, with scores of 0.
  int minimum_class_size = 2;
  bool finds_itself = false;  ///< a query is retrieved like any other target, instead of being excluded from its list
};

/// Returns the measures of an evaluation: those of the options or the default ones.
std::vector<Measure> evaluated_measures(const EvaluationOptions& options);

/// Returns the cache versions, by name, of all measures that an evaluation computes.
std::map<std::string, int> measure_versions(const EvaluationOptions& options);

/// Parameters of EvaluationOptions other than the protocol, the measures and the curve.
inline constexpr std::array evaluation_table = {
    option_of<&EvaluationOptions::ties>("ties",
                                        "Order of models at equal distance: by index, relevant models first or last, "
                                        "or the mean over all orders."),
    option_of<&EvaluationOptions::minimum_class_size>(
        "minimum_class_size", {.low = 1, .high = 1'000'000},
        "Minimum class size of queries (psbTable of the Princeton Shape Benchmark: 3; 1: also judged queries without a "
        "relevant model, with scores of 0)."),
};

/// Mean first tier (FT) over the queries with tied relevant models ranked last (pessimistic) and first (optimistic).
struct FirstTierBounds {
  double pessimistic = 0;
  double optimistic = 0;
};

/// Scores of a distance matrix under one protocol: fractions from 0 to 1. Column j of every table is measures[j].
struct Evaluation {
  Protocol protocol = Protocol::psb;
  Ties ties = Ties::index;
  CurveKind curve = CurveKind::psb;
  std::vector<std::string> measures;  ///< "NN", "FT", "ST", "E", "DCG", "mAP"
  std::vector<Eigen::Index> queries;  ///< matrix row of each query
  std::vector<int> query_classes;     ///< class of each query
  Eigen::MatrixXd per_query;          ///< queries x measures
  std::vector<int> classes;           ///< labels with queries, ascending
  Eigen::MatrixXd per_class;          ///< classes x measures
  Eigen::VectorXd micro;              ///< mean over queries
  Eigen::VectorXd macro;              ///< mean over classes
  PrecisionRecallCurve micro_curve;
  PrecisionRecallCurve macro_curve;
  std::vector<PrecisionRecallCurve> class_curves;  ///< by classes
  Eigen::Index excluded_models = 0;                ///< queries excluded because they have too few relevant models
  Eigen::Index queries_with_ties = 0;              ///< queries with a relevant and another model at equal distance
  FirstTierBounds first_tier_bounds;               ///< independent of `measures`; equal if ties have no effect
};

/// References to all members, for codecs (experiments/cache/codec.h).
/// @{
SHAPEGAUGE_MEMBERS(PrecisionRecallCurve, recall, precision)
SHAPEGAUGE_MEMBERS(FirstTierBounds, pessimistic, optimistic)
SHAPEGAUGE_MEMBERS(Evaluation, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q)
/// @}

/// Evaluates a distance matrix against the models' classes, with every model as a query to all others
/// (docs/reference/definitions.md#measures). labels[i] is the class of model i. Distances need not be symmetric and may
/// be infinite (ranked_list()); the diagonal is ignored. Models that are not queries stay in the others' lists.
/// Parallel over queries, with the same bytes for any number of threads. Throws ArgumentError for a matrix that is
/// empty, not square or of another size than labels, a distance that is NaN (the message has row and column, counted
/// from 0), a minimum class size out of range, and if no class is large enough.
Evaluation evaluate(const DistanceTable& distances, std::span<const int> labels, const EvaluationOptions& options);

/// Evaluates a matrix whose rows and columns are described by a task. Throws ArgumentError as above, and for a matrix
/// of another size than the task's.
Evaluation evaluate(const DistanceTable& distances, const RetrievalTask& task, const EvaluationOptions& options);

/// Streaming version of evaluate(), for matrices that do not fit into memory. Requests blocks of a few hundred rows
/// sequentially. The result is bit-identical. Throws as above.
Evaluation evaluate(const RowSource& distances, const RetrievalTask& task, const EvaluationOptions& options);

/// Evaluates ranked answers, one per row of the task. Memory is proportional to their models. Throws ArgumentError for
/// another number of answers than the task's rows, and as above.
Evaluation evaluate(const RankedAnswerLists& answers, const RetrievalTask& task, const EvaluationOptions& options);

/// Scores of some queries, in their order.
struct QueryScores {
  Eigen::MatrixXd measures;           ///< queries x measures
  Eigen::MatrixXd precisions;         ///< queries x recall levels
  std::vector<std::size_t> relevant;  ///< number of relevant models, by query
  std::vector<char> tied;             ///< flag for ties, by query
  Eigen::MatrixX2d first_tiers;       ///< per query: FT under Ties::pessimistic and Ties::optimistic
};

/// Streaming version of evaluate() for all rows of a matrix or a part of them. Several processes may each evaluate some
/// rows; evaluation_of() combines their scores. The task must outlive the object. With `finds_itself` it must have no
/// own columns; evaluate() sets them to -1.
class RowEvaluator {
 public:
  /// Prepares the evaluation of the rows [first, last). Throws as evaluate() does.
  RowEvaluator(const RetrievalTask& task, const EvaluationOptions& options, Eigen::Index first, Eigen::Index last);

  /// Evaluates the queries among rows of the matrix, from the row `first` on. Parallel. Throws ArgumentError for a
  /// distance that is NaN.
  void evaluate(const DistanceTable& rows, Eigen::Index first);

  /// Evaluates the answers to the queries of all rows. Parallel.
  void evaluate(const RankedAnswerLists& answers);

  /// Returns the scores of the queries among the rows evaluated.
  [[nodiscard]] const QueryScores& scores() const { return scores_; }

  /// Combines the scores of all queries of the task into an evaluation.
  [[nodiscard]] Evaluation evaluation_of(const QueryScores& all) const;

 private:
  template <typename ListOf>
  void evaluate_rows(Eigen::Index first, Eigen::Index last, const ListOf& list_of);
  void keep(std::size_t score, const RankedList& list);

  Relevance relevance_;
  std::vector<Measure> measures_;
  Measure first_tier_;
  Evaluation blank_;             ///< without scores
  std::size_t largest_ = 0;      ///< largest number of relevant models of a query
  std::size_t first_query_ = 0;  ///< first query among the rows
  QueryScores scores_;
};

}  // namespace shapegauge

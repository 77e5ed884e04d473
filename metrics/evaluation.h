#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/metrics/measures.h"
#include "shapegauge/metrics/precision_recall.h"
#include "shapegauge/metrics/protocol.h"
#include "shapegauge/metrics/ranked_list.h"
#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// Settings of an evaluation.
struct EvaluationOptions {
  Protocol protocol = Protocol::psb;
  Ties ties = Ties::index;
  std::vector<Measure> measures{};   ///< empty: default_measures(protocol)
  std::optional<CurveKind> curve{};  ///< nothing: usual_curve(protocol)
  /// Models of smaller classes are no queries; at least 2, the query counted (psbTable: 3). Every query then has at
  /// least one relevant model fewer than that, whether it is itself a target or not.
  int minimum_class_size = 2;
};

/// Mean first tier (FT) over the queries with tied relevant models last (pessimistic) and first (optimistic).
struct FirstTierBounds {
  double pessimistic = 0;
  double optimistic = 0;
};

/// The scores of a distance matrix under one protocol: fractions from 0 to 1. Column j of every table is measures[j].
struct Evaluation {
  Protocol protocol = Protocol::psb;
  Ties ties = Ties::index;
  CurveKind curve = CurveKind::psb;
  std::vector<std::string> measures;  ///< "NN", "FT", "ST", "E", "DCG", "mAP"
  std::vector<Eigen::Index> queries;  ///< row of the matrix of each query
  std::vector<int> query_classes;     ///< class of each query
  Eigen::MatrixXd per_query;          ///< queries x measures
  std::vector<int> classes;           ///< labels that have queries, ascending
  Eigen::MatrixXd per_class;          ///< classes x measures
  Eigen::VectorXd micro;              ///< mean over queries
  Eigen::VectorXd macro;              ///< mean over classes
  PrecisionRecallCurve micro_curve;
  PrecisionRecallCurve macro_curve;
  std::vector<PrecisionRecallCurve> class_curves;  ///< by classes
  Eigen::Index models_left_out = 0;                ///< rows that would be queries but have too few relevant models
  Eigen::Index queries_with_ties = 0;              ///< queries with relevant and other models at equal distance
  FirstTierBounds first_tier_bounds;               ///< independent of `measures`; equal where ties change nothing
};

/// Evaluates a distance matrix against the models' classes, every model a query to all others
/// (docs/reference/definitions.md#measures). labels[i] is the class of model i. Distances need not be symmetric and may
/// be infinite; the diagonal plays no part. Models that are no queries stay in the others' lists. Parallel over
/// queries; the same bytes for any number of threads. Throws ArgumentError: matrix empty, not square or of another size
/// than labels, a distance that is NaN (naming row and column, counted from 0), a minimum class size below 2, no class
/// large enough.
Evaluation evaluate(const DistanceTable& distances, std::span<const int> labels, const EvaluationOptions& options);

/// Evaluates a matrix whose rows and columns are what the task says. Throws ArgumentError as above, and where
/// the task is for a matrix of another size.
Evaluation evaluate(const DistanceTable& distances, const RetrievalTask& task, const EvaluationOptions& options);

/// `count` rows of a distance matrix from the row `first` on.
using RowSource = std::function<DistanceMatrix(Eigen::Index first, Eigen::Index count)>;

/// Streaming version of evaluate(), for matrices that do not fit into memory: asks for a few hundred rows at a time, in
/// order, one call after the other. The same result to the bit. Throws as above.
Evaluation evaluate(const RowSource& distances, const RetrievalTask& task, const EvaluationOptions& options);

/// What was found of some queries, in their order.
struct QueryScores {
  Eigen::MatrixXd measures;           ///< queries x measures
  Eigen::MatrixXd precisions;         ///< queries x recall levels
  std::vector<std::size_t> relevant;  ///< of each query
  std::vector<char> tied;             ///< of each query
  Eigen::MatrixX2d first_tiers;       ///< of each query: FT under Ties::pessimistic and Ties::optimistic
};

/// Streaming version of evaluate() that is given the rows, of all of the matrix or of a part of it: several processes
/// may each judge some rows, and what they found is put together by evaluation_of(). The task must outlive it.
class RowJudge {
 public:
  /// For the rows from `first` to before `last`. Throws as evaluate().
  RowJudge(const RetrievalTask& task, const EvaluationOptions& options, Eigen::Index first, Eigen::Index last);

  /// Judges the queries among rows of the matrix, from the row `first` on. In parallel. Throws ArgumentError
  /// for a distance that is NaN.
  void judge(const DistanceTable& rows, Eigen::Index first);

  /// What was found of the queries among all rows that it is for.
  [[nodiscard]] const QueryScores& scores() const { return scores_; }

  /// The evaluation, from the scores of all queries of the task.
  [[nodiscard]] Evaluation evaluation_of(const QueryScores& all) const;

 private:
  void keep(std::size_t score, const RankedList& list);

  const RetrievalTask* task_;
  std::vector<Measure> measures_;
  Measure first_tier_;
  Evaluation blank_;             ///< without figures
  std::size_t largest_ = 0;      ///< number of relevant models of a query
  std::size_t first_query_ = 0;  ///< of those among its rows
  QueryScores scores_;
};

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "shapegauge/metrics/protocol.h"
#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// Returns the indices of the `count` models nearest to a query, in order of distance (ties: smaller index first), or
/// of all other models if there are fewer. `distances` are the distances from the query to all models, and `query` is
/// the index of the query. Infinite distances rank last. The query is excluded by its index: a duplicate of it at
/// distance 0 stays. No distance may be NaN.
std::vector<Eigen::Index> first_ranked(std::span<const double> distances, Eigen::Index query, Eigen::Index count);

/// Run of consecutive ranks that hold relevant and other models in unknown order (ties). All orders are equally likely.
struct RankRun {
  std::size_t size = 0;              ///< number of ranks in the run
  std::size_t hits = 0;              ///< number of relevant models in the run
  std::size_t misses = size - hits;  ///< number of models judged as not relevant; without judgements all but the hits
  double grade = 1;                  ///< mean relevance grade of the hits

  bool operator==(const RankRun&) const = default;
};

/// Ranked answer to one query, the input of measures. A measure is the mean over all orders that the runs permit. Only
/// Ties::expected permits more than one order.
struct RankedList {
  std::vector<RankRun> runs;  ///< runs in order of rank; adjacent runs of misses, or of hits of one grade, are merged
  std::size_t length = 0;     ///< number of ranks, that is, of models in the list
  std::size_t relevant = 0;   ///< number of relevant models, including those missing from the list
  bool starts_with_query = false;  ///< true if rank 1 is the query itself, which counts as a hit
  bool tied = false;  ///< true if relevant and other models, or different grades, are at equal distance: the order of
                      ///< ties may matter
  /// Precision at each hit: entry k - 1 is the mean of k / rank of the k-th hit. One entry per relevant model; 0 for
  /// models missing from the list.
  std::vector<double> precision_at_hit;
  std::size_t judged_misses = 0;  ///< number of models judged as not relevant, including those missing from the list
  std::vector<double> grades;     ///< grades of all relevant models, in descending order; if empty, all grades are 1
};

/// Model in the answer to a query: its column in the RetrievalTask and its distance from the query, not NaN.
struct ListedModel {
  Eigen::Index column = 0;  ///< column of the model in the task
  double distance = 0;      ///< distance from the query, not NaN
};

/// Answers to the queries of a RetrievalTask: the listed models of each row, in any order. Models that are not listed
/// count as not found.
using RankedAnswerLists = std::vector<std::vector<ListedModel>>;

/// Protocol and order of ties by which ranked_list() builds lists.
struct ListConventions {
  Protocol protocol = Protocol::psb;  ///< protocol, which sets whether the list contains the query
  Ties ties = Ties::index;            ///< order of models at equal distance
};

/// Ranked lists of one answer with ties, with tied relevant models last (pessimistic) and first (optimistic).
struct TieExtremes {
  RankedList pessimistic;  ///< list with relevant models last among tied ones
  RankedList optimistic;   ///< list with relevant models first among tied ones
};

/// Builds the ranked list of the query in row `row` from its answer. Under psb and trec it has the listed targets
/// without the query; under paper the query itself is first. Infinite distances rank last. An empty answer gives an
/// empty list under every protocol. Sets `extremes`, if not null, if the list is tied.
RankedList ranked_list(std::span<const ListedModel> answer, const Relevance& relevance, Eigen::Index row,
                       const ListConventions& conventions, std::optional<TieExtremes>* extremes = nullptr);

/// Builds the ranked list of the query in row `row` from its row of a distance matrix, with one distance per column, as
/// from an answer that lists all columns. The list is empty if all targets are infinitely far.
RankedList ranked_list(std::span<const double> distances, const Relevance& relevance, Eigen::Index row,
                       const ListConventions& conventions, std::optional<TieExtremes>* extremes = nullptr);

/// Builds a ranked list from runs in order of rank; merges adjacent runs of misses, or of hits of one grade.
/// `not_in_list` is the number of relevant models that are missing from the list.
RankedList list_of_runs(const std::vector<RankRun>& runs, bool starts_with_query = false, std::size_t not_in_list = 0);

/// Returns the number of hits among the first `count` ranks, or in the whole list if it is shorter; mean over the
/// orders of ties.
double hits_among_first(const RankedList& list, std::size_t count);

/// Returns the sum of gain(rank) over all hits, as the mean over the orders of ties; ranks count from 1.
double gain_of_hits(const RankedList& list, double (*gain)(std::size_t rank));

/// Returns the sum of grade times gain(rank) over the hits among the first `count` ranks, as the mean over the orders
/// of ties; ranks count from 1.
double graded_gain_of_hits(const RankedList& list, double (*gain)(std::size_t rank), std::size_t count);

/// Returns the sum of the precisions at the hits among the first `count` ranks, as the mean over the orders of ties.
double sum_of_precisions(const RankedList& list, std::size_t count);

/// Returns, for each hit of the list in order of rank, the number of models judged as not relevant that rank before the
/// hit, but at most `most`; mean over the orders of ties.
std::vector<double> misses_before_hits(const RankedList& list, std::size_t most);

}  // namespace shapegauge

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

/// Returns the `count` models nearest to a query, in order of distance (ties: smaller index first); all of them if
/// there are no more. `distances` are those from the query to all models, and `query` is its own index. Infinite
/// distances rank last. The query is excluded by its index: a duplicate of it at distance 0 stays. No distance may be
/// NaN.
std::vector<Eigen::Index> first_ranked(std::span<const double> distances, Eigen::Index query, Eigen::Index count);

/// Run of consecutive ranks: `size` of them, with `hits` relevant models. All orders within the run are equally likely.
struct RankRun {
  std::size_t size = 0;
  std::size_t hits = 0;
  std::size_t misses = size - hits;  ///< models judged as not relevant; all but the hits if there are no judgements
  double grade = 1;                  ///< mean grade of the hits

  bool operator==(const RankRun&) const = default;
};

/// Ranked answer to one query, as input of measures. A measure is the mean over all orders that the runs permit. With
/// all ties but Ties::expected there is only one order.
struct RankedList {
  std::vector<RankRun> runs;       ///< in order of rank; no two adjacent runs consist of only hits or only misses
  std::size_t length = 0;          ///< number of ranks
  std::size_t relevant = 0;        ///< number of relevant models, including those missing from the list
  bool starts_with_query = false;  ///< rank 1 is the query itself, which counts as a hit
  bool tied = false;  ///< relevant and other models, or different grades, are at equal distance: their order may matter
  /// By k - 1, the mean of k / rank of the k-th hit, for each relevant model; 0 for those missing from the list.
  std::vector<double> precision_at_hit;
  std::size_t judged_misses = 0;  ///< models judged as not relevant, including those missing from the list
  std::vector<double> grades;     ///< of all relevant models, in descending order; all 1 if empty
};

/// Model of an answer: a column of the task with its distance, which is not NaN.
struct ListedModel {
  Eigen::Index column = 0;
  double distance = 0;
};

/// Answers to the queries of a task, by row. Models may be in any order; those that are absent are not found.
using RankedAnswerLists = std::vector<std::vector<ListedModel>>;

/// Conventions for the lists of an evaluation.
struct ListConventions {
  Protocol protocol = Protocol::psb;
  Ties ties = Ties::index;
};

/// Lists of an answer whose order of ties matters, for its extreme orders.
struct TieExtremes {
  RankedList pessimistic;
  RankedList optimistic;
};

/// Builds the list that a protocol evaluates. psb and trec: the targets without the query. paper: the query itself,
/// then the others. Infinite distances rank last. The list is empty under every protocol if the answer is, or if all
/// targets are infinitely far. If the list is tied, sets `extremes`, if given.
RankedList ranked_list(std::span<const ListedModel> answer, const Relevance& relevance, Eigen::Index row,
                       const ListConventions& conventions, std::optional<TieExtremes>* extremes = nullptr);

/// Builds the list of a row of a distance matrix, which has a distance for each column.
RankedList ranked_list(std::span<const double> distances, const Relevance& relevance, Eigen::Index row,
                       const ListConventions& conventions, std::optional<TieExtremes>* extremes = nullptr);

/// Builds a list from runs and a number of relevant models that are missing from it. Adjacent runs may be of the same
/// kind.
RankedList list_of_runs(const std::vector<RankRun>& runs, bool starts_with_query = false, std::size_t not_in_list = 0);

/// Returns the mean number of hits among the first `count` ranks, or in the whole list if it is shorter.
double hits_among_first(const RankedList& list, std::size_t count);

/// Returns the mean sum of gain(rank) over all hits; ranks count from 1.
double gain_of_hits(const RankedList& list, double (*gain)(std::size_t rank));

/// Returns the mean sum of grade times gain(rank) over the hits among the first `count` ranks.
double graded_gain_of_hits(const RankedList& list, double (*gain)(std::size_t rank), std::size_t count);

/// Returns the mean sum of the precisions at the hits among the first `count` ranks.
double precisions_at_hits(const RankedList& list, std::size_t count);

/// Returns, by hit of the list, the mean number of judged misses before it, limited to `most`.
std::vector<double> misses_before_hits(const RankedList& list, std::size_t most);

}  // namespace shapegauge

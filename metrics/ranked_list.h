#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "shapegauge/metrics/protocol.h"
#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

/// The first `count` of all models but the query, the nearest first: by distance, and models at equal distance by
/// index. `distances` are the query's to all models, `query` its own index. Infinite distances rank last. The query is
/// left out by its index, so a duplicate of it at distance 0 stays, and its own distance to itself plays no part. No
/// distance may be NaN. All of them where there are no more.
std::vector<Eigen::Index> first_ranked(std::span<const double> distances, Eigen::Index query, Eigen::Index count);

/// Consecutive ranks, `size` of them with `hits` relevant models. Where both kinds are among them their order is open:
/// every order is as likely as any other.
struct RankRun {
  std::size_t size = 0;
  std::size_t hits = 0;
  std::size_t misses =
      size - hits;   ///< models that are judged and not relevant; all that are no hits without judgements
  double grade = 1;  ///< mean grade of the hits

  bool operator==(const RankRun&) const = default;
};

/// All that a measure may know about the answer to one query. A measure is the mean over all orders that the runs leave
/// open; where they leave none open, which is so for all ties but Ties::expected, it is the measure of that one order.
struct RankedList {
  std::vector<RankRun> runs;       ///< the first ranks first; no two neighbours that are both all hits or both no hits
  std::size_t length = 0;          ///< number of ranks
  std::size_t relevant = 0;        ///< number of relevant models, those that are not in the list too; at least 1
  bool starts_with_query = false;  ///< rank 1 is the query itself, which counts as a hit
  bool tied = false;  ///< relevant and other models, or grades, are at equal distance: their order could matter
  /// The mean of k / rank of the k-th hit, by k - 1, for each of the relevant models; 0 for those not in the list.
  std::vector<double> precision_at_hit;
  std::size_t judged_misses = 0;  ///< models that are judged and not relevant, those that are not in the list too
  std::vector<double> grades;     ///< of all relevant models, the largest first; empty: all are 1
};

/// The list that a protocol judges: under psb and trec the targets without the query; under paper the query, by
/// identity, and then the others. Distances are those of the task's rows and columns; none may be NaN unless lists may
/// end early.
RankedList ranked_list(const DistanceTable& distances, const RetrievalTask& task, Eigen::Index row, Protocol protocol,
                       Ties ties);

/// The list of the runs, with further relevant models that are not in it. Runs may be neighbours of the same kind.
RankedList list_of_runs(const std::vector<RankRun>& runs, bool starts_with_query = false, std::size_t not_in_list = 0);

/// Mean number of hits among the first `count` ranks, or in the whole list where that is shorter.
double hits_among_first(const RankedList& list, std::size_t count);

/// Mean of the sum of gain(rank) over all hits; ranks count from 1.
double gain_of_hits(const RankedList& list, double (*gain)(std::size_t rank));

/// The same of grade times gain(rank).
double graded_gain_of_hits(const RankedList& list, double (*gain)(std::size_t rank));

/// By hit of the list, the mean of the number of judged misses before it, counted up to `most`.
std::vector<double> misses_before_hits(const RankedList& list, std::size_t most);

}  // namespace shapegauge

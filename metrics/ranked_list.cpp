#include "shapegauge/metrics/ranked_list.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace shapegauge {

/// Appends, for each of `hits` relevant models among `size` consecutive ranks in open order, the mean of k / rank of
/// the k-th hit of the list: k counts on from the precisions that are there, ranks from `ranks_before`.
///
/// In all orders of n ranks with m hits, the j-th hit is at the t-th of them with the probability
/// C(t-1, j-1) C(n-t, m-j) / C(n, m) (negative hypergeometric); the mean is the sum over t, with terms below 1e-18 of
/// the largest one left out.
void append_precisions(std::vector<double>& precisions, std::size_t size, std::size_t hits, std::size_t ranks_before);

namespace {

constexpr double negligible = 1e-18;  // of the largest term: less than the rounding of the sum

// The mean of 1 / (ranks_before + t) for the place t of the j-th of `hits` hits among `size` places. Probabilities are
// taken relative to that of the likeliest place, from which they fall to both sides, so that nothing under- or
// overflows whatever the sizes are.
double mean_reciprocal_rank(std::size_t size, std::size_t hits, std::size_t j, std::size_t ranks_before) {
  const std::size_t first = j;
  const std::size_t last = size - hits + j;
  const std::size_t likeliest = hits == 1 ? first : std::clamp(1 + (j - 1) * size / (hits - 1), first, last);
  // P(t + 1) / P(t)
  const auto ratio = [&](std::size_t t) {
    return static_cast<double>(t) * static_cast<double>(last - t) /
           (static_cast<double>(t - j + 1) * static_cast<double>(size - t));
  };
  double total = 1;
  double sum = 1 / static_cast<double>(ranks_before + likeliest);
  double probability = 1;
  for (std::size_t t = likeliest; t < last && probability > negligible; ++t) {
    probability *= ratio(t);
    total += probability;
    sum += probability / static_cast<double>(ranks_before + t + 1);
  }
  probability = 1;
  for (std::size_t t = likeliest; t > first && probability > negligible; --t) {
    probability /= ratio(t - 1);
    total += probability;
    sum += probability / static_cast<double>(ranks_before + t - 1);
  }
  return sum / total;
}

}  // namespace

void append_precisions(std::vector<double>& precisions, std::size_t size, std::size_t hits, std::size_t ranks_before) {
  const std::size_t hits_before = precisions.size();
  for (std::size_t j = 1; j <= hits; ++j) {
    const auto k = static_cast<double>(hits_before + j);
    precisions.push_back(hits == size ? k / static_cast<double>(ranks_before + j)
                                      : k * mean_reciprocal_rank(size, hits, j, ranks_before));
  }
}

namespace {

struct RankedModel {
  double distance;
  Eigen::Index column;
};

void sort_by_distance(std::vector<RankedModel>& models) {
  std::ranges::sort(models, [](const RankedModel& a, const RankedModel& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.column < b.column;
  });
}

// The models at one distance, at least one of them relevant, and how many others are nearer than these but farther than
// the relevant ones before.
struct Tied {
  double distance = 0;
  std::size_t others_before = 0;
  std::vector<Eigen::Index> hits;    // ascending
  std::vector<Eigen::Index> others;  // ascending
};

// What is known of an answer without sorting all of it: the relevant models in their order, and how many others there
// are between them.
struct Answer {
  std::vector<Tied> tied;
  std::size_t others_behind = 0;   // farther than the last relevant model
  std::size_t hits_not_found = 0;  // relevant models that have no distance
};

bool is_target(const RetrievalTask& task, Eigen::Index row, Eigen::Index column) {
  return task.target_classes[static_cast<std::size_t>(column)] != no_class &&
         task.own_column[static_cast<std::size_t>(row)] != column;
}

void collect_hits(const DistanceTable& distances, const RetrievalTask& task, Eigen::Index row, Answer& answer) {
  std::vector<RankedModel> hits;
  for (Eigen::Index column = 0; column < distances.cols(); ++column) {
    if (!is_target(task, row, column) || !is_relevant(task, row, column)) continue;
    if (std::isnan(distances(row, column))) {
      ++answer.hits_not_found;
    } else {
      hits.push_back({distances(row, column), column});
    }
  }
  sort_by_distance(hits);
  for (const RankedModel& hit : hits) {
    if (answer.tied.empty() || answer.tied.back().distance != hit.distance) {
      answer.tied.push_back({.distance = hit.distance, .others_before = 0, .hits = {}, .others = {}});
    }
    answer.tied.back().hits.push_back(hit.column);
  }
}

void collect_others(const DistanceTable& distances, const RetrievalTask& task, Eigen::Index row, Answer& answer) {
  for (Eigen::Index column = 0; column < distances.cols(); ++column) {
    if (!is_target(task, row, column) || is_relevant(task, row, column)) continue;
    const double distance = distances(row, column);
    if (std::isnan(distance)) continue;
    const auto place = std::ranges::lower_bound(answer.tied, distance, {}, &Tied::distance);
    if (place == answer.tied.end()) {
      ++answer.others_behind;
    } else if (place->distance == distance) {
      place->others.push_back(column);
    } else {
      ++place->others_before;
    }
  }
}

void append(RankedList& list, const RankRun& run) {
  if (run.size == 0) return;
  list.length += run.size;
  const bool same_kind =
      !list.runs.empty() && ((run.hits == 0 && list.runs.back().hits == 0) ||
                             (run.hits == run.size && list.runs.back().hits == list.runs.back().size));
  if (same_kind) {
    list.runs.back().size += run.size;
    list.runs.back().hits += run.hits;
  } else {
    list.runs.push_back(run);
  }
}

void append_by_index(RankedList& list, const Tied& tied) {
  auto hit = tied.hits.begin();
  for (const Eigen::Index other : tied.others) {
    for (; hit != tied.hits.end() && *hit < other; ++hit) append(list, {1, 1});
    append(list, {1, 0});
  }
  for (; hit != tied.hits.end(); ++hit) append(list, {1, 1});
}

// The tied models in the order, or the open order, that `ties` wants.
void append_tied(RankedList& list, const Tied& tied, Ties ties) {
  const std::size_t hits = tied.hits.size();
  const std::size_t others = tied.others.size();
  if (others > 0) list.tied = true;
  switch (ties) {
    case Ties::index:
      append_by_index(list, tied);
      break;
    case Ties::optimistic:
      append(list, {hits, hits});
      append(list, {others, 0});
      break;
    case Ties::pessimistic:
      append(list, {others, 0});
      append(list, {hits, hits});
      break;
    case Ties::expected:
      append(list, {hits + others, hits});
      break;
  }
}

void finish(RankedList& list, std::size_t relevant) {
  list.relevant = relevant;
  list.precision_at_hit.reserve(relevant);
  std::size_t ranks_before = 0;
  for (const RankRun& run : list.runs) {
    append_precisions(list.precision_at_hit, run.size, run.hits, ranks_before);
    ranks_before += run.size;
  }
  list.precision_at_hit.resize(relevant, 0.0);
}

std::size_t hits_in(const RankedList& list) {
  std::size_t hits = 0;
  for (const RankRun& run : list.runs) hits += run.hits;
  return hits;
}

}  // namespace

std::vector<Eigen::Index> ranked_models(const DistanceTable& distances, Eigen::Index query) {
  std::vector<RankedModel> models;
  models.reserve(static_cast<std::size_t>(distances.cols()));
  for (Eigen::Index column = 0; column < distances.cols(); ++column) {
    if (column != query) models.push_back({distances(query, column), column});
  }
  sort_by_distance(models);
  std::vector<Eigen::Index> columns;
  columns.reserve(models.size());
  for (const RankedModel& model : models) columns.push_back(model.column);
  return columns;
}

RankedList ranked_list(const DistanceTable& distances, const RetrievalTask& task, Eigen::Index row, Protocol protocol,
                       Ties ties) {
  RankedList list;
  list.starts_with_query = protocol == Protocol::paper;
  if (list.starts_with_query) append(list, {1, 1});
  Answer answer;
  collect_hits(distances, task, row, answer);
  collect_others(distances, task, row, answer);
  for (const Tied& tied : answer.tied) {
    append(list, {tied.others_before, 0});
    append_tied(list, tied, ties);
  }
  append(list, {answer.others_behind, 0});
  finish(list, hits_in(list) + answer.hits_not_found);
  return list;
}

RankedList list_of_runs(const std::vector<RankRun>& runs, bool starts_with_query, std::size_t not_in_list) {
  RankedList list;
  list.starts_with_query = starts_with_query;
  for (const RankRun& run : runs) append(list, run);
  finish(list, hits_in(list) + not_in_list);
  return list;
}

RankedList list_of_hits(const std::vector<bool>& hits, bool starts_with_query, std::size_t not_in_list) {
  std::vector<RankRun> runs;
  runs.reserve(hits.size());
  for (const bool hit : hits) runs.push_back({1, hit ? 1U : 0U});
  return list_of_runs(runs, starts_with_query, not_in_list);
}

double hits_among_first(const RankedList& list, std::size_t count) {
  double hits = 0;
  for (const RankRun& run : list.runs) {
    const std::size_t looked_at = std::min(count, run.size);
    hits += static_cast<double>(run.hits) * static_cast<double>(looked_at) / static_cast<double>(run.size);
    count -= looked_at;
    if (count == 0) break;
  }
  return hits;
}

double gain_of_hits(const RankedList& list, double (*gain)(std::size_t rank)) {
  double sum = 0;
  std::size_t rank = 0;
  for (const RankRun& run : list.runs) {
    if (run.hits > 0) {
      const double share = static_cast<double>(run.hits) / static_cast<double>(run.size);
      for (std::size_t i = 1; i <= run.size; ++i) sum += share * gain(rank + i);
    }
    rank += run.size;
  }
  return sum;
}

}  // namespace shapegauge

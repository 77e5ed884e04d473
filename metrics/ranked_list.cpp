#include "shapegauge/metrics/ranked_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shapegauge/metrics/tied_hits.h"

namespace shapegauge {
namespace {

// A model and its distance side by side: sorting does not jump about in the matrix.
struct RankedModel {
  double distance;
  Eigen::Index column;
};

void sort_by_distance(std::vector<RankedModel>& models) {
  std::ranges::sort(models, [](const RankedModel& a, const RankedModel& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.column < b.column;
  });
}

std::vector<RankedModel> sorted_targets(const DistanceTable& distances, const RetrievalTask& task, Eigen::Index row) {
  std::vector<RankedModel> models;
  models.reserve(task.target_classes.size());
  for (Eigen::Index column = 0; column < distances.cols(); ++column) {
    const auto j = static_cast<std::size_t>(column);
    if (task.target_classes[j] == no_class || task.own_column[static_cast<std::size_t>(row)] == column) continue;
    if (std::isnan(distances(row, column))) continue;
    models.push_back({distances(row, column), column});
  }
  sort_by_distance(models);
  return models;
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

// The tied models in the order, or the open order, that `ties` wants.
void append_tied(RankedList& list, const std::vector<bool>& relevant, Ties ties) {
  const auto hits = static_cast<std::size_t>(std::count(relevant.begin(), relevant.end(), true));
  const RankRun all{relevant.size(), hits};
  const RankRun only_hits{hits, hits};
  const RankRun no_hits{relevant.size() - hits, 0};
  if (hits > 0 && hits < relevant.size()) list.tied = true;
  switch (ties) {
    case Ties::index:
      for (const bool hit : relevant) append(list, {1, hit ? 1U : 0U});
      break;
    case Ties::optimistic:
      append(list, only_hits);
      append(list, no_hits);
      break;
    case Ties::pessimistic:
      append(list, no_hits);
      append(list, only_hits);
      break;
    case Ties::expected:
      append(list, all);
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

// Relevant targets that are not in the list.
std::size_t relevant_without_distance(const DistanceTable& distances, const RetrievalTask& task, Eigen::Index row) {
  if (!task.lists_may_end_early) return 0;
  std::size_t count = 0;
  for (Eigen::Index column = 0; column < distances.cols(); ++column) {
    const bool target = task.target_classes[static_cast<std::size_t>(column)] != no_class &&
                        task.own_column[static_cast<std::size_t>(row)] != column;
    if (target && std::isnan(distances(row, column)) && is_relevant(task, row, column)) ++count;
  }
  return count;
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
  const std::vector<RankedModel> models = sorted_targets(distances, task, row);
  std::vector<bool> relevant;
  for (std::size_t i = 0; i < models.size(); ++i) {
    relevant.push_back(is_relevant(task, row, models[i].column));
    const bool last_of_tied = i + 1 == models.size() || models[i + 1].distance != models[i].distance;
    if (!last_of_tied) continue;
    append_tied(list, relevant, ties);
    relevant.clear();
  }
  finish(list, hits_in(list) + relevant_without_distance(distances, task, row));
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

#include "shapegauge/metrics/ranked_list.h"

#include <algorithm>

namespace shapegauge {

std::vector<Eigen::Index> ranked_models(const DistanceTable& distances, Eigen::Index query) {
  std::vector<Eigen::Index> models;
  models.reserve(static_cast<std::size_t>(distances.cols()));
  for (Eigen::Index model = 0; model < distances.cols(); ++model) {
    if (model != query) models.push_back(model);
  }
  std::ranges::sort(models, [&](Eigen::Index a, Eigen::Index b) {
    const double to_a = distances(query, a);
    const double to_b = distances(query, b);
    return to_a != to_b ? to_a < to_b : a < b;
  });
  return models;
}

RankedList ranked_list(const DistanceTable& distances, std::span<const int> labels, Eigen::Index query,
                       Protocol protocol) {
  RankedList list;
  list.hits.reserve(labels.size());
  list.starts_with_query = protocol == Protocol::paper;
  if (list.starts_with_query) list.hits.push_back(true);
  const int wanted = labels[static_cast<std::size_t>(query)];
  for (const Eigen::Index model : ranked_models(distances, query)) {
    list.hits.push_back(labels[static_cast<std::size_t>(model)] == wanted);
  }
  list.relevant = hits_among_first(list, list.hits.size());
  return list;
}

std::size_t hits_among_first(const RankedList& list, std::size_t count) {
  const auto end = list.hits.begin() + static_cast<std::ptrdiff_t>(std::min(count, list.hits.size()));
  return static_cast<std::size_t>(std::count(list.hits.begin(), end, true));
}

std::vector<std::size_t> ranks_of_hits(const RankedList& list) {
  std::vector<std::size_t> ranks;
  ranks.reserve(list.relevant);
  for (std::size_t i = 0; i < list.hits.size(); ++i) {
    if (list.hits[i]) ranks.push_back(i + 1);
  }
  return ranks;
}

}  // namespace shapegauge

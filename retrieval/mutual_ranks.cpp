// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/mutual_ranks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace shapegauge {

namespace {

/// Returns 0 and the ranks of distances_at_ranks() among that many models.
std::vector<double> ranks_among(Eigen::Index models) {
  std::vector<double> ranks{0};
  const Eigen::Index last = models - 1;
  for (Eigen::Index rank = 1; rank < last; rank += std::max<Eigen::Index>(1, rank / 16)) {
    ranks.push_back(static_cast<double>(rank));
  }
  if (last > 0) ranks.push_back(static_cast<double>(last));
  return ranks;
}

/// Returns the rank of a finite distance. `ranks` are ranks_among(), `at_ranks` the distances at all but the first.
double rank_of(double distance, std::span<const double> at_ranks, std::span<const double> ranks) {
  if (!(distance > 0)) return 0;
  const auto farther = static_cast<std::size_t>(std::ranges::upper_bound(at_ranks, distance) - at_ranks.begin());
  if (farther == at_ranks.size() || std::isinf(at_ranks[farther])) return ranks[farther];
  const double nearer = farther > 0 ? at_ranks[farther - 1] : 0;
  const double share = (distance - nearer) / (at_ranks[farther] - nearer);
  return ranks[farther] + share * (ranks[farther + 1] - ranks[farther]);
}

}  // namespace

Eigen::Index sampled_rank_count(Eigen::Index models) { return std::ssize(ranks_among(models)) - 1; }

Eigen::RowVectorXd distances_at_ranks(std::span<const double> distances, Eigen::Index itself) {
  std::vector<double> sorted;
  for (std::size_t j = 0; j < distances.size(); ++j) {
    if (std::cmp_equal(j, itself)) continue;
    if (distances[j] > 0 && std::isfinite(distances[j])) sorted.push_back(distances[j]);
  }
  std::ranges::sort(sorted);
  const std::vector<double> ranks = ranks_among(std::ssize(distances));
  Eigen::RowVectorXd found(std::ssize(ranks) - 1);
  for (Eigen::Index k = 0; k < found.size(); ++k) {
    const auto rank = static_cast<std::size_t>(ranks[static_cast<std::size_t>(k) + 1]);
    found[k] = rank <= sorted.size() ? sorted[rank - 1] : std::numeric_limits<double>::infinity();
  }
  return found;
}

Eigen::RowVectorXd log_mutual_ranks(std::span<const double> distances, const Eigen::RowVectorXd& model_at_ranks,
                                    const DistanceMatrix& others) {
  const std::vector<double> ranks = ranks_among(std::ssize(distances));
  const auto count = static_cast<std::size_t>(model_at_ranks.size());
  Eigen::RowVectorXd logarithms(std::ssize(distances));
  for (Eigen::Index j = 0; j < logarithms.size(); ++j) {
    const double distance = distances[static_cast<std::size_t>(j)];
    const double rank = rank_of(distance, {model_at_ranks.data(), count}, ranks) +
                        rank_of(distance, {others.row(j).data(), static_cast<std::size_t>(others.cols())}, ranks);
    logarithms[j] = std::isinf(distance) ? distance : std::log1p(rank / 2);
  }
  return logarithms;
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/proxy/sample_connectivity.h"

#include <algorithm>

namespace shapegauge {

SampleConnectivity::SampleConnectivity(const DenseSamples& samples)
    : samples_(samples),
      nearest_(nearest_neighbours(samples.points, std::min<Eigen::Index>(8, samples.points.rows() - 1))),
      visited_by_(static_cast<std::size_t>(samples.points.rows()), 0) {}

bool SampleConnectivity::connected_in_ball(std::int32_t from, std::int32_t to, const Eigen::Vector3d& centre,
                                           double distance) {
  constexpr double slack = 1.5;
  const double squared_radius = slack * slack * distance * distance / 4;
  ++search_;
  queue_.assign(1, from);
  visited_by_[static_cast<std::size_t>(from)] = search_;
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const std::int32_t here = queue_[next];
    if (here == to) return true;
    for (Eigen::Index k = 0; k < nearest_.indices.cols(); ++k) {
      const std::int32_t other = nearest_.indices(here, k);
      const double step = nearest_.distances(here, k);
      if (visited_by_[static_cast<std::size_t>(other)] == search_) continue;
      if (!((samples_.points.row(other).transpose() - centre).squaredNorm() <= squared_radius)) continue;
      if (step > 0 && !on_same_sheet(samples_, here, other, step)) continue;
      visited_by_[static_cast<std::size_t>(other)] = search_;
      queue_.push_back(other);
    }
  }
  return false;
}

}  // namespace shapegauge

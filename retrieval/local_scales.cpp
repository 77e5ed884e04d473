// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/local_scales.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

#include "shapegauge/core/base/median.h"
#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {

double mean_distance_to_nearest(std::span<const double> distances, Eigen::Index itself) {
  constexpr std::ptrdiff_t nearest = 10;
  std::vector<double> known;
  for (std::size_t j = 0; j < distances.size(); ++j) {
    if (std::cmp_equal(j, itself)) continue;
    if (distances[j] > 0 && std::isfinite(distances[j])) known.push_back(distances[j]);
  }
  const auto count = std::min(std::ssize(known), nearest);
  if (count == 0) return std::numeric_limits<double>::quiet_NaN();
  std::ranges::partial_sort(known, known.begin() + count);
  return overflow_safe_mean({known.data(), static_cast<std::size_t>(count)});
}

LocalScales LocalScales::of_means(const Eigen::VectorXd& means) {
  constexpr double min_share = 0.01;  // of the median
  LocalScales scales;
  std::vector<double> known;
  std::ranges::copy_if(means, std::back_inserter(known), [](double mean) { return !std::isnan(mean); });
  if (!known.empty()) scales.least = min_share * upper_median(known);
  scales.roots = means.unaryExpr([&](double mean) { return scales.root_of(mean); });
  return scales;
}

double LocalScales::root_of(double mean) const { return std::isnan(mean) ? 1 : std::sqrt(std::max(mean, least)); }

Eigen::RowVectorXd LocalScales::scaled(const Eigen::RowVectorXd& distances, double root) const {
  return distances.array() / (root * roots.transpose().array());
}

}  // namespace shapegauge

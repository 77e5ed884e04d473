#include "shapegauge/retrieval/local_scales.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
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
  constexpr double least_share = 0.01;  // of the median
  LocalScales scales;
  std::vector<double> known;
  std::ranges::copy_if(means, std::back_inserter(known), [](double mean) { return !std::isnan(mean); });
  if (!known.empty()) scales.least = least_share * upper_median(known);
  scales.roots = means.unaryExpr([&](double mean) { return scales.root_of(mean); });
  return scales;
}

double spread_of_scaled(const Eigen::VectorXd& means, const LocalScales& scales, const RowSource& rows) {
  constexpr Eigen::Index most_rows = 64;
  const Eigen::Index models = means.size();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(models));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::stable_sort(order, {}, [&](Eigen::Index model) {
    return std::isnan(means[model]) ? std::numeric_limits<double>::infinity() : means[model];
  });
  const Eigen::Index count = std::min(models, most_rows);
  std::vector<double> scaled;
  scaled.reserve(static_cast<std::size_t>(count * models));
  for (Eigen::Index r = 0; r < count; ++r) {
    const Eigen::Index model = order[static_cast<std::size_t>(((2 * r + 1) * models) / (2 * count))];
    const DistanceMatrix row = rows(model, 1);
    for (Eigen::Index j = 0; j < models; ++j) {
      const double distance = row(0, j) / (scales.roots[model] * scales.roots[j]);
      if (j != model && std::isfinite(distance)) scaled.push_back(distance);
    }
  }
  if (scaled.empty()) return 1;
  const auto quartile = [&](std::ptrdiff_t fourths) {
    const auto place = scaled.begin() + (std::ssize(scaled) - 1) * fourths / 4;
    std::ranges::nth_element(scaled, place);
    return *place;
  };
  const double range = quartile(3) - quartile(1);
  return range > 0 ? range : 1;
}

double LocalScales::root_of(double mean) const { return std::isnan(mean) ? 1 : std::sqrt(std::max(mean, least)); }

}  // namespace shapegauge

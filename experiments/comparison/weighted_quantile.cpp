#include "shapegauge/experiments/comparison/weighted_quantile.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace shapegauge {

double weighted_quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, double share) {
  if (values.size() != weights.size()) throw std::invalid_argument("as many weights as values are needed");
  const double total = weights.sum();
  if (!(total > 0)) return std::numeric_limits<double>::quiet_NaN();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::stable_sort(order, {}, [&](Eigen::Index i) { return values[i]; });
  double below = 0;
  for (const Eigen::Index i : order) {
    below += weights[i];
    if (weights[i] > 0 && below >= share * total) return values[i];
  }
  return values[order.back()];  // rounding kept the sum short of the total
}

}  // namespace shapegauge

#include "shapegauge/metrics/statistics/effect_size.h"

#include <cmath>
#include <stdexcept>

namespace shapegauge {

double effect_size(const Eigen::VectorXd& differences) {
  if (differences.size() < 2) throw std::invalid_argument("an effect size needs at least two differences");
  const double mean = differences.mean();
  if (mean == 0) return 0;
  const auto count = static_cast<double>(differences.size());
  return mean / std::sqrt((differences.array() - mean).square().sum() / (count - 1));
}

}  // namespace shapegauge

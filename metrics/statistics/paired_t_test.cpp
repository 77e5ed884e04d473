#include "shapegauge/metrics/statistics/paired_t_test.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace shapegauge {

PairedT paired_t_test(const Eigen::VectorXd& differences) {
  if (differences.size() < 2) throw std::invalid_argument("a paired t-test needs at least two differences");
  const auto count = static_cast<double>(differences.size());
  const double mean = differences.mean();
  const double variance = (differences.array() - mean).square().sum() / (count - 1);
  PairedT result{.t = 0, .degrees_of_freedom = static_cast<int>(differences.size()) - 1, .p = 1};
  if (mean == 0) return result;
  if (variance == 0) {
    result.t = std::copysign(std::numeric_limits<double>::infinity(), mean);
    result.p = 0;
    return result;
  }
  result.t = mean / std::sqrt(variance / count);
  const boost::math::students_t student(count - 1);
  result.p = 2 * boost::math::cdf(boost::math::complement(student, std::abs(result.t)));
  return result;
}

}  // namespace shapegauge

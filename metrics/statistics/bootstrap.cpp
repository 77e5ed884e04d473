#include "shapegauge/metrics/statistics/bootstrap.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tbb/parallel_for.h>

#include "shapegauge/random/random_numbers.h"

namespace shapegauge {
namespace {

// The share of the resampled averages to leave out on each side.
double tail_of(double confidence, Eigen::Index units) {
  const auto n = static_cast<double>(units);
  const boost::math::students_t student(n - 1);
  const double t = boost::math::quantile(boost::math::complement(student, (1 - confidence) / 2));
  return boost::math::cdf(boost::math::normal(), -std::sqrt(n / (n - 1)) * t);
}

// Linear between the order statistics, of which the i-th of B is taken as the quantile i / (B + 1).
double quantile(const Eigen::VectorXd& sorted, double share) {
  const auto count = static_cast<double>(sorted.size());
  const double position = std::clamp(share * (count + 1) - 1, 0.0, count - 1);
  const auto below = static_cast<Eigen::Index>(position);
  const Eigen::Index above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (position - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

Eigen::MatrixXd bootstrap_averages(const Units& units, const ResamplingOptions& options) {
  if (options.resamples < 1) {
    throw std::invalid_argument("a bootstrap needs at least one resample, not " + std::to_string(options.resamples));
  }
  const auto count = static_cast<std::uint64_t>(units.values.rows());
  Eigen::MatrixXd averages(options.resamples, units.values.cols());
  tbb::parallel_for(0, options.resamples, [&](int resample) {
    RandomNumbers random(options.seed, static_cast<std::uint64_t>(resample));
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(units.values.cols());
    double weight = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto drawn = static_cast<Eigen::Index>(random.below(count));
      sum += units.weights[drawn] * units.values.row(drawn);
      weight += units.weights[drawn];
    }
    averages.row(resample) = sum / weight;
  });
  return averages;
}

std::vector<ConfidenceInterval> percentile_intervals(const Eigen::MatrixXd& resampled, Eigen::Index units,
                                                     double confidence) {
  if (units < 2) {
    throw std::invalid_argument("a confidence interval needs at least two classes or queries to draw from, there is " +
                                std::to_string(units));
  }
  if (!(confidence > 0 && confidence < 1)) {
    throw std::invalid_argument("the confidence must be between 0 and 1, not " + std::to_string(confidence));
  }
  const double tail = tail_of(confidence, units);
  std::vector<ConfidenceInterval> intervals;
  for (Eigen::Index method = 0; method < resampled.cols(); ++method) {
    Eigen::VectorXd sorted = resampled.col(method);
    std::ranges::sort(sorted);
    intervals.push_back({quantile(sorted, tail), quantile(sorted, 1 - tail)});
  }
  return intervals;
}

std::vector<ConfidenceInterval> bootstrap_intervals(const Units& units, double confidence,
                                                    const ResamplingOptions& options) {
  return percentile_intervals(bootstrap_averages(units, options), units.values.rows(), confidence);
}

}  // namespace shapegauge

#include "shapegauge/metrics/statistics/randomisation_test.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "shapegauge/random/random_numbers.h"

namespace shapegauge {
namespace {

constexpr double rounding = 1e-12;  // of the sum of all magnitudes: sums in other signs round otherwise

// The sum of the terms in random signs, 64 of them from each random number.
double sum_in_random_signs(const Eigen::VectorXd& terms, RandomNumbers random) {
  double sum = 0;
  std::uint64_t bits = 0;
  for (Eigen::Index i = 0; i < terms.size(); ++i) {
    if (i % 64 == 0) bits = random.next();
    sum += (bits & 1U) != 0 ? terms[i] : -terms[i];
    bits >>= 1U;
  }
  return sum;
}

}  // namespace

double randomisation_p_value(const Eigen::VectorXd& differences, const Eigen::VectorXd& weights,
                             const ResamplingOptions& options) {
  if (options.resamples < 1) {
    throw std::invalid_argument("a randomisation test needs at least one resample, not " +
                                std::to_string(options.resamples));
  }
  if (differences.size() == 0) throw std::invalid_argument("no units for a randomisation test");
  const Eigen::VectorXd terms = differences.cwiseProduct(weights);
  const double observed = std::abs(terms.sum()) - rounding * terms.cwiseAbs().sum();
  const int as_extreme = tbb::parallel_reduce(
      tbb::blocked_range<int>(0, options.resamples), 0,
      [&](const tbb::blocked_range<int>& range, int count) {
        for (int resample = range.begin(); resample < range.end(); ++resample) {
          const RandomNumbers random(options.seed, static_cast<std::uint64_t>(resample));
          if (std::abs(sum_in_random_signs(terms, random)) >= observed) ++count;
        }
        return count;
      },
      [](int a, int b) { return a + b; });
  return (1.0 + as_extreme) / (1.0 + options.resamples);
}

}  // namespace shapegauge

#include "shapegauge/metrics/statistics/tukey_hsd.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tbb/parallel_for.h>
#include <vector>

#include "shapegauge/random/random_numbers.h"

namespace shapegauge {
namespace {

constexpr double rounding = 1e-12;  // of the largest average: sums in another order round otherwise

// The averages of the methods after a shuffle (Fisher and Yates) of their values within every unit.
Eigen::VectorXd shuffled_averages(const Units& units, RandomNumbers random) {
  Eigen::VectorXd averages = Eigen::VectorXd::Zero(units.values.cols());
  for (Eigen::Index unit = 0; unit < units.values.rows(); ++unit) {
    Eigen::RowVectorXd values = units.values.row(unit);
    for (Eigen::Index last = values.size() - 1; last > 0; --last) {
      std::swap(values[last], values[static_cast<Eigen::Index>(random.below(static_cast<std::uint64_t>(last) + 1))]);
    }
    averages += units.weights[unit] * values.transpose();
  }
  return averages;
}

}  // namespace

Eigen::MatrixXd tukey_hsd_p_values(const Units& units, const ResamplingOptions& options) {
  if (options.resamples < 1) {
    throw std::invalid_argument("a randomised test needs at least one resample, not " +
                                std::to_string(options.resamples));
  }
  if (units.values.size() == 0) throw std::invalid_argument("no units for a randomised Tukey test");
  std::vector<double> ranges(static_cast<std::size_t>(options.resamples));
  tbb::parallel_for(0, options.resamples, [&](int resample) {
    const Eigen::VectorXd averages =
        shuffled_averages(units, RandomNumbers(options.seed, static_cast<std::uint64_t>(resample)));
    ranges[static_cast<std::size_t>(resample)] = averages.maxCoeff() - averages.minCoeff();
  });
  std::ranges::sort(ranges);
  const Eigen::VectorXd averages = averages_of(units);
  const double slack = rounding * averages.cwiseAbs().maxCoeff();
  const Eigen::Index methods = averages.size();
  Eigen::MatrixXd p_values = Eigen::MatrixXd::Ones(methods, methods);
  for (Eigen::Index a = 0; a < methods; ++a) {
    for (Eigen::Index b = 0; b < methods; ++b) {
      if (a == b) continue;
      const auto first = std::ranges::lower_bound(ranges, std::abs(averages[a] - averages[b]) - slack);
      p_values(a, b) = (1.0 + static_cast<double>(ranges.end() - first)) / (1.0 + options.resamples);
    }
  }
  return p_values;
}

}  // namespace shapegauge

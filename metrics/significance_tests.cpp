// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/significance_tests.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/base/parallel_parts.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/metrics/ascending_order.h"
#include "shapegauge/metrics/equal_scores.h"

namespace shapegauge {

namespace {

// Sums the terms with random signs, 64 from each random number.
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
    throw ArgumentError("a randomisation test needs at least one resample, not " + std::to_string(options.resamples));
  }
  if (differences.size() == 0)
    throw ArgumentError("a randomisation test needs at least one difference, and there is none");
  const Eigen::VectorXd terms = differences.cwiseProduct(weights);
  // Relative to the summed magnitudes: the rounding of sums depends on order and signs.
  const double observed = std::abs(terms.sum()) - score_rounding * terms.cwiseAbs().sum();
  const int as_extreme = interruptible_parallel_reduce(
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

double paired_t_p_value(const Eigen::VectorXd& differences) {
  if (differences.size() < 2) {
    throw ArgumentError("a paired t-test needs at least two differences, not " + std::to_string(differences.size()));
  }
  const auto count = static_cast<double>(differences.size());
  const double mean = differences.mean();
  const double variance = (differences.array() - mean).square().sum() / (count - 1);
  if (mean == 0) return 1;
  if (variance == 0) return 0;
  const boost::math::students_t student(count - 1);
  return 2 * boost::math::cdf(boost::math::complement(student, std::abs(mean / std::sqrt(variance / count))));
}

namespace {

// Averages the methods after shuffling (Fisher and Yates) their values within every unit.
Eigen::VectorXd shuffled_averages(const UnitValues& units, RandomNumbers random) {
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

Eigen::MatrixXd tukey_hsd_p_values(const UnitValues& units, const ResamplingOptions& options) {
  if (options.resamples < 1) {
    throw ArgumentError("a randomised Tukey test needs at least one resample, not " +
                        std::to_string(options.resamples));
  }
  if (units.values.size() == 0) {
    throw ArgumentError("a randomised Tukey test needs at least one query and method, not " +
                        std::to_string(units.values.rows()) + " and " + std::to_string(units.values.cols()));
  }
  std::vector<double> ranges(static_cast<std::size_t>(options.resamples));
  parallel_for(0, options.resamples, [&](int resample) {
    const Eigen::VectorXd averages =
        shuffled_averages(units, RandomNumbers(options.seed, static_cast<std::uint64_t>(resample)));
    ranges[static_cast<std::size_t>(resample)] = averages.maxCoeff() - averages.minCoeff();
  });
  std::ranges::sort(ranges);
  const Eigen::VectorXd averages = averages_of(units);
  const double slack = score_rounding * averages.cwiseAbs().maxCoeff();
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

double min_attainable_tukey_p_value(Eigen::Index methods, Eigen::Index units, const ResamplingOptions& options) {
  if (methods < 2 || units < 2) return 1;
  const auto k = static_cast<double>(methods);
  return std::max(1.0 / (1.0 + options.resamples), std::pow(k * (k - 1), 1.0 - static_cast<double>(units)));
}

std::vector<double> adjust_by_holm(std::span<const double> p_values) {
  const std::vector<std::size_t> ascending = ascending_order(p_values);
  std::vector<double> adjusted(p_values.size());
  double largest = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    const auto tests_left = static_cast<double>(ascending.size() - i);
    largest = std::max(largest, std::min(1.0, tests_left * p_values[ascending[i]]));
    adjusted[ascending[i]] = largest;
  }
  return adjusted;
}

double effect_size(const Eigen::VectorXd& differences) {
  if (differences.size() < 2) {
    throw ArgumentError("an effect size needs at least two differences, not " + std::to_string(differences.size()));
  }
  const double mean = differences.mean();
  if (mean == 0) return 0;
  const Eigen::ArrayXd deviations = differences.array() - mean;
  const bool constant = deviations.abs().maxCoeff() <= score_rounding * std::abs(mean);
  if (constant) return std::copysign(std::numeric_limits<double>::infinity(), mean);
  return mean / std::sqrt(deviations.square().sum() / static_cast<double>(differences.size() - 1));
}

WinTieLoss win_tie_loss(const Eigen::VectorXd& differences) {
  return {.wins = (differences.array() > 0).count(),
          .ties = (differences.array() == 0).count(),
          .losses = (differences.array() < 0).count()};
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/friedman_test.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/metrics/ascending_order.h"
#include "shapegauge/metrics/equal_scores.h"
#include "shapegauge/metrics/studentised_range.h"

namespace shapegauge {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Ranks one data set, the largest value first; adds t^3 - t for each group of t tied methods.
Eigen::VectorXd ranks_of(const Eigen::VectorXd& values, double& ties) {
  Eigen::VectorXd ranks(values.size());
  double before = 0;
  for (const std::vector<std::size_t>& group : groups_of_equal_scores(values)) {
    const auto tied = static_cast<double>(group.size());
    for (const std::size_t i : group) ranks[static_cast<Eigen::Index>(i)] = before + (tied + 1) / 2;
    ties += tied * tied * tied - tied;
    before += tied;
  }
  return ranks;
}

// Returns the probability that random rankings of all data sets are equal, for rankings with these ranks.
double chance_of_equal_rankings(const Eigen::VectorXd& ranks, double sets) {
  double log_orders = std::lgamma(static_cast<double>(ranks.size()) + 1);
  for (const std::vector<std::size_t>& tied : groups_of_equal_scores(ranks)) {
    log_orders -= std::lgamma(static_cast<double>(tied.size()) + 1);
  }
  return std::exp((1 - sets) * log_orders);
}

FriedmanTest friedman_of(const Eigen::VectorXd& mean_ranks, double sets, double ties) {
  const auto methods = static_cast<double>(mean_ranks.size());
  FriedmanTest test;
  if (methods < 2 || sets < 2) return test;
  test.tie_correction = 1 - ties / (sets * (methods * methods * methods - methods));
  if (test.tie_correction <= 0) return test;  // all values are equal
  const double spread = (mean_ranks.array() - (methods + 1) / 2).square().sum();
  test.chi_squared = 12 * sets / (methods * (methods + 1)) * spread / test.tie_correction;
  test.p = boost::math::cdf(boost::math::complement(boost::math::chi_squared(methods - 1), test.chi_squared));
  const double rest = sets * (methods - 1) - test.chi_squared;
  if (rest <= score_rounding * sets * methods) {
    test.f = infinity;
    test.f_p = chance_of_equal_rankings(mean_ranks, sets);
    return test;
  }
  test.f = (sets - 1) * test.chi_squared / rest;
  const boost::math::fisher_f distribution(methods - 1, (methods - 1) * (sets - 1));
  test.f_p = boost::math::cdf(boost::math::complement(distribution, test.f));
  return test;
}

/// Compares all pairs of methods; differences of mean ranks are measured in `unit`.
std::vector<RankDifference> rank_differences(const Eigen::MatrixXd& values, const Eigen::VectorXd& mean_ranks,
                                             double unit, bool tested) {
  std::vector<RankDifference> pairs;
  for (Eigen::Index a = 0; a < values.cols(); ++a) {
    for (Eigen::Index b = a + 1; b < values.cols(); ++b) {
      RankDifference pair{.first = static_cast<std::size_t>(a), .second = static_cast<std::size_t>(b)};
      pair.mean_ranks = mean_ranks[a] - mean_ranks[b];
      const double range = std::sqrt(2.0) * std::abs(pair.mean_ranks) / unit;
      if (tested) pair.p = 1 - studentised_range_probability(range, static_cast<std::size_t>(values.cols()));
      pair.data_sets = win_tie_loss(score_differences(values.col(a), values.col(b)));
      pairs.push_back(pair);
    }
  }
  return pairs;
}

}  // namespace

RankComparison compare_by_ranks(const Eigen::MatrixXd& values, double alpha) {
  if (values.size() == 0) {
    throw ArgumentError("a comparison by ranks needs at least one method and one data set, not " +
                        std::to_string(values.cols()) + " and " + std::to_string(values.rows()));
  }
  if (!values.allFinite()) throw ArgumentError("values of methods on data sets must be finite numbers");
  if (!(alpha > 0 && alpha < 1))
    throw ArgumentError("the significance level is " + std::to_string(alpha) + "; it must be between 0 and 1");
  const auto sets = static_cast<double>(values.rows());
  const auto methods = static_cast<double>(values.cols());
  RankComparison comparison;
  comparison.ranks.resize(values.rows(), values.cols());
  double ties = 0;
  for (Eigen::Index set = 0; set < values.rows(); ++set) {
    comparison.ranks.row(set) = ranks_of(values.row(set).transpose(), ties).transpose();
  }
  comparison.mean_ranks = comparison.ranks.colwise().mean().transpose();
  comparison.order = ascending_order(comparison.mean_ranks);
  comparison.friedman = friedman_of(comparison.mean_ranks, sets, ties);

  const double unit = std::sqrt(methods * (methods + 1) / (6 * sets));
  const auto count = static_cast<std::size_t>(values.cols());
  const bool tested = count > 1 && values.rows() > 1;
  if (tested) comparison.critical_difference = studentised_range_quantile(alpha, count) / std::sqrt(2.0) * unit;
  if (count > 1 && !tested) comparison.critical_difference = infinity;
  const auto rank_at = [&](std::size_t position) {
    return comparison.mean_ranks[static_cast<Eigen::Index>(comparison.order[position])];
  };
  comparison.groups = homogeneous_groups(
      count, [&](std::size_t i, std::size_t j) { return rank_at(j) - rank_at(i) > comparison.critical_difference; });
  if (count <= max_paired_methods) comparison.pairs = rank_differences(values, comparison.mean_ranks, unit, tested);
  return comparison;
}

std::vector<RankInterval> rank_intervals(const Eigen::MatrixXd& ranks, double confidence,
                                         const ResamplingOptions& options) {
  // Weights of 1 keep sums of ranks exact, so that equal ones are equal.
  const UnitValues units{.values = ranks, .weights = Eigen::VectorXd::Ones(ranks.rows())};
  Eigen::MatrixXd positions = bootstrap_averages(units, options);
  parallel_for(0, options.resamples, [&](int resample) {
    const Eigen::RowVectorXd mean_ranks = positions.row(resample);
    Eigen::RowVectorXd sorted = mean_ranks;
    std::ranges::sort(sorted);
    for (Eigen::Index method = 0; method < mean_ranks.size(); ++method) {
      const auto first = std::ranges::lower_bound(sorted, mean_ranks[method]);
      positions(resample, method) = 1 + static_cast<double>(first - sorted.begin());
    }
  });
  std::vector<RankInterval> intervals;
  for (const auto& [low, high] : percentile_intervals(positions, ranks.rows(), confidence)) {
    intervals.push_back({.best = static_cast<std::size_t>(std::floor(low + score_rounding)),
                         .worst = static_cast<std::size_t>(std::ceil(high - score_rounding))});
  }
  return intervals;
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/metrics/homogeneous_groups.h"
#include "shapegauge/metrics/significance_tests.h"

namespace shapegauge {

/// Result of Friedman's test of k methods on N data sets.
struct FriedmanTest {
  double chi_squared = 0;     ///< Friedman's chi-squared statistic, corrected for ties
  double tie_correction = 1;  ///< divisor of `chi_squared` for ties; 1 without ties, 0 if all values are equal
  double p = 1;               ///< p-value of `chi_squared`, with k - 1 degrees of freedom for k methods
  double f = 0;               ///< Iman and Davenport's statistic; infinite if all data sets have the same ranks
  /// p-value of `f`: F distribution with k - 1 and (k - 1)(N - 1) degrees of freedom for k methods on N data sets. If
  /// `f` is infinite, the exact probability that random rankings of all data sets are equal.
  double f_p = 1;
};

/// Difference in rank between two methods over all data sets.
struct RankDifference {
  std::size_t first = 0;   ///< index of the first method
  std::size_t second = 0;  ///< index of the second method
  double mean_ranks = 0;   ///< mean rank of `first` minus mean rank of `second`; negative if `first` is better
  double p = 1;            ///< p-value of Nemenyi's test, corrected for all pairs of methods
  WinTieLoss data_sets{};  ///< number of data sets on which `first` is better, equal and worse
};

/// Comparison of several methods by their ranks on several data sets; result of compare_by_ranks().
struct RankComparison {
  Eigen::MatrixXd ranks;           ///< data sets x methods: ranks from 1, the best; equal values share their mean rank
  Eigen::VectorXd mean_ranks;      ///< mean rank of each method over the data sets
  FriedmanTest friedman;           ///< test of the ranks; p-values are 1 for one method or one data set
  double critical_difference = 0;  ///< Nemenyi's critical difference; infinite for one data set, 0 for one method
  std::vector<std::size_t> order;  ///< indices of methods by increasing mean rank; ties by index
  std::vector<HomogeneousGroup> groups;  ///< methods that do not differ significantly, as positions in `order`
  std::vector<RankDifference> pairs;     ///< all pairs of methods; empty for more than max_paired_methods
};

/// Maximum number of methods for which compare_by_ranks() tests and lists all pairs.
inline constexpr std::size_t max_paired_methods = 50;

/// Compares k methods by their values on N data sets, larger being better; `values` is N x k. Friedman's test has the
/// null hypothesis that all methods are equal; Iman and Davenport's statistic is less conservative. Two methods differ
/// significantly at the level `alpha` if their mean ranks differ by more than Nemenyi's critical difference q / sqrt(2)
/// sqrt(k (k + 1) / (6 N)), where q is the 1 - alpha quantile of the studentised range of k values. Demsar,
/// "Statistical comparisons of classifiers over multiple data sets", Journal of Machine Learning Research 7, 2006. The
/// approximations are valid for N above 10 and k above 5. Throws ArgumentError without values, for a value that is not
/// finite, and for an alpha that is not between 0 and 1.
RankComparison compare_by_ranks(const Eigen::MatrixXd& values, double alpha = 0.05);

/// Confidence interval of a method's rank among all methods; rank 1 is the best.
struct RankInterval {
  std::size_t best = 1;   ///< smallest rank of the interval
  std::size_t worst = 1;  ///< largest rank of the interval

  bool operator==(const RankInterval&) const = default;
};

/// Computes a bootstrap confidence interval of each method's rank among the methods by mean rank. Resamples the data
/// sets, which are treated as a random sample of all such data sets. `ranks` is RankComparison::ranks. Percentiles are
/// widened for few data sets, see bootstrap_intervals(), and rounded outwards. Throws ArgumentError for fewer than two
/// data sets, and for a confidence or options out of range.
std::vector<RankInterval> rank_intervals(const Eigen::MatrixXd& ranks, double confidence = 0.95,
                                         const ResamplingOptions& options = {});

}  // namespace shapegauge

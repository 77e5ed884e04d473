// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/metrics/homogeneous_groups.h"
#include "shapegauge/metrics/significance_tests.h"

namespace shapegauge {

/// Friedman's test of several methods on several data sets.
struct FriedmanTest {
  double chi_squared = 0;     ///< corrected for ties
  double tie_correction = 1;  ///< divisor of the uncorrected statistic; 1 without ties
  double p = 1;               ///< chi-squared distribution with k - 1 degrees of freedom
  double f = 0;               ///< Iman and Davenport's statistic; infinite if all data sets have the same ranks
  /// F distribution with k - 1 and (k - 1)(N - 1) degrees of freedom; if F is infinite, the exact probability of equal
  /// ranks
  double f_p = 1;
};

/// Difference between two methods over data sets, first minus second.
struct RankDifference {
  std::size_t first = 0;
  std::size_t second = 0;
  double mean_ranks = 0;   ///< difference of the mean ranks; negative if the first is better
  double p = 1;            ///< Nemenyi's test, corrected for all pairs
  WinTieLoss data_sets{};  ///< by number of data sets
};

/// Comparison of several methods on several data sets by ranks.
struct RankComparison {
  Eigen::MatrixXd ranks;       ///< data sets x methods, 1 the best; equal values (are_equal_scores()) share the mean
  Eigen::VectorXd mean_ranks;  ///< per method
  FriedmanTest friedman;       ///< defaults for one method or one data set
  double critical_difference = 0;        ///< of mean ranks (Nemenyi); infinite for one data set, 0 for one method
  std::vector<std::size_t> order;        ///< methods by increasing mean rank; ties in their own order
  std::vector<HomogeneousGroup> groups;  ///< positions in `order` of methods that do not differ significantly
  std::vector<RankDifference> pairs;     ///< none for more than max_paired_methods
};

/// Number of methods up to which all pairs are tested and listed.
inline constexpr std::size_t max_paired_methods = 50;

/// Compares k methods by their values on N data sets, larger being better; `values` is N x k. Friedman's test has the
/// null hypothesis that all methods are equal; Iman and Davenport's statistic is less conservative. Two methods differ
/// significantly at `alpha` if their mean ranks differ by more than Nemenyi's critical difference q / sqrt(2) sqrt(k (k
/// + 1) / (6 N)), where q is the studentised range of k values. Demsar, "Statistical comparisons of classifiers over
/// multiple data sets", Journal of Machine Learning Research 7, 2006. The approximations are valid for N above 10 and k
/// above 5. Throws ArgumentError without values, for a value that is not finite, and for an alpha that is not between 0
/// and 1.
RankComparison compare_by_ranks(const Eigen::MatrixXd& values, double alpha = 0.05);

/// Confidence interval of a method's position among all, 1 the best.
struct RankInterval {
  std::size_t best = 1;
  std::size_t worst = 1;

  bool operator==(const RankInterval&) const = default;
};

/// Computes bootstrap intervals of the methods' positions by mean rank: data sets are resampled, as a sample of all
/// such data sets. `ranks` are data sets x methods. Percentiles are widened for few data sets, see
/// bootstrap_intervals(), and rounded outwards. Throws ArgumentError for fewer than two data sets, and for a confidence
/// or options out of range.
std::vector<RankInterval> rank_intervals(const Eigen::MatrixXd& ranks, double confidence = 0.95,
                                         const ResamplingOptions& options = {});

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "shapegauge/metrics/homogeneous_groups.h"
#include "shapegauge/metrics/significance_tests.h"

namespace shapegauge {

/// Friedman's test of several methods on several data sets.
struct FriedmanTest {
  double chi_squared = 0;     ///< corrected for ties
  double tie_correction = 1;  ///< what the statistic without correction was divided by; 1 without ties
  double p = 1;               ///< chi-squared distribution with k - 1 degrees of freedom
  double f = 0;               ///< of Iman and Davenport; infinite where all data sets rank alike
  double f_p = 1;             ///< F distribution with k - 1 and (k - 1)(N - 1) degrees of freedom
};

/// What two methods differ by over data sets, first minus second.
struct RankDifference {
  std::size_t first = 0;
  std::size_t second = 0;
  double mean_ranks = 0;   ///< difference of the mean ranks; negative: the first is better
  double p = 1;            ///< of Nemenyi's test, which corrects for all pairs
  WinTieLoss data_sets{};  ///< on how many the first is better
};

/// Several methods on several data sets, by ranks.
struct RankComparison {
  Eigen::MatrixXd ranks;           ///< data sets x methods, 1 the best; equal values share the mean of their ranks
  Eigen::VectorXd mean_ranks;      ///< by method
  FriedmanTest friedman;           ///< defaults for one method, or one data set
  double critical_difference = 0;  ///< of mean ranks (Nemenyi); infinite for one data set, 0 for one method
  std::vector<std::size_t> order;  ///< methods by mean rank, the best first; equal ones in their own order
  std::vector<HomogeneousGroup> groups;  ///< positions in the order: methods that do not differ significantly
  std::vector<RankDifference> pairs;
};

/// Compares k methods by their values on N data sets, larger being better; values is N x k. Friedman's test asks
/// whether all methods are alike; Iman and Davenport's statistic is less conservative. Two methods differ
/// significantly at `alpha` where their mean ranks differ by more than Nemenyi's critical difference
/// q / sqrt(2) sqrt(k (k + 1) / (6 N)), q the studentised range of k values. Demsar, "Statistical comparisons of
/// classifiers over multiple data sets", Journal of Machine Learning Research 7, 2006. The approximations are for N
/// above 10 and k above 5. Throws ArgumentError: no values, a value that is not finite, an alpha that is not between 0
/// and 1.
RankComparison compare_by_ranks(const Eigen::MatrixXd& values, double alpha = 0.05);

}  // namespace shapegauge

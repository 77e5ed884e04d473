// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "shapegauge/metrics/bootstrap.h"

namespace shapegauge {

/// Computes the two-sided p-value of a paired randomisation (permutation) test. Under the null hypothesis the two
/// methods are exchangeable in each resampling unit. The p-value is (1 + #) / (B + 1), where # counts those of B random
/// exchanges whose difference of averages is at least as far from 0 as the observed one; it is never 0. `differences`
/// and `weights` have one entry per unit. Fisher, "The design of experiments", 1935; for retrieval: Smucker, Allan,
/// Carterette, CIKM 2007. Throws ArgumentError without resamples or units.
double randomisation_p_value(const Eigen::VectorXd& differences, const Eigen::VectorXd& weights,
                             const ResamplingOptions& options = {});

/// Computes the two-sided p-value of Student's t-test of the mean of paired differences against 0 ("Student",
/// Biometrika 6, 1908). 1 if all differences are 0, 0 if they are equal and not 0. Assumes independent differences and
/// a normally distributed mean. For values between 0 and 1 with many ties the latter holds from some dozens of
/// differences on. Throws ArgumentError for fewer than two differences.
double paired_t_p_value(const Eigen::VectorXd& differences);

/// Computes p-values of all pairs of methods by randomised Tukey HSD ("honestly significant differences"): methods x
/// methods, 1 on the diagonal. Each of B resamples shuffles the methods' values within every unit and computes the
/// range of the averages, that is, the largest minus the smallest. The p-value of a pair is (1 + #) / (B + 1), where #
/// counts the ranges that are at least as large as the difference of the pair. No further correction is needed.
/// Carterette, "Multiple testing in statistical analysis of systems-based information retrieval experiments", ACM TOIS
/// 30, 2012. Throws ArgumentError without resamples or units.
Eigen::MatrixXd tukey_hsd_p_values(const UnitValues& units, const ResamplingOptions& options = {});

/// Returns the smallest p-value that tukey_hsd_p_values() can return: the larger of two bounds. A random shuffle of k
/// methods within n units gives one of any two methods the largest and the other the smallest value of each unit with
/// probability (k (k - 1))^(1 - n). With B resamples no p-value is below 1 / (B + 1). 1 for fewer than two methods or
/// units.
double min_attainable_tukey_p_value(Eigen::Index methods, Eigen::Index units, const ResamplingOptions& options);

/// Adjusts p-values for multiple testing by Holm's method, which controls the family-wise error rate under any
/// dependence. With p-values in ascending order, the i-th of m becomes the maximum of (m - j + 1) p_j for j <= i, at
/// most 1. Returned in the order of the input. Holm, "A simple sequentially rejective multiple test procedure",
/// Scandinavian Journal of Statistics 6, 1979.
std::vector<double> adjust_by_holm(std::span<const double> p_values);

/// Computes Cohen's d for paired differences (d_z): their mean divided by their sample standard deviation. About 0.2 is
/// called small, 0.5 medium, 0.8 large. 0 if all differences are 0, infinite if they are equal and not 0. Unlike a
/// p-value it does not grow with the number of queries. Cohen, "Statistical power analysis for the behavioral
/// sciences", 1988, section 2.3. Throws ArgumentError for fewer than two differences.
double effect_size(const Eigen::VectorXd& differences);

/// Number of queries or data sets on which the first of two methods has the larger, the same and the smaller value.
struct WinTieLoss {
  Eigen::Index wins = 0;    ///< number of queries or data sets with a larger value of the first method
  Eigen::Index ties = 0;    ///< number of queries or data sets with equal values (are_equal_scores())
  Eigen::Index losses = 0;  ///< number of queries or data sets with a smaller value of the first method
};

/// Counts positive, zero and negative entries of the score_differences() of two methods, first minus second.
WinTieLoss win_tie_loss(const Eigen::VectorXd& differences);

}  // namespace shapegauge

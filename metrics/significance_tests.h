#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "shapegauge/metrics/bootstrap.h"

namespace shapegauge {

/// Paired randomisation (permutation) test, two-sided: if two methods were equally good, which of them is called which
/// would be a matter of chance in each unit. The p-value is (1 + #) / (B + 1), where # counts those of B random
/// exchanges whose difference of averages is at least as far from 0 as the observed one; it is never 0. `differences`
/// and `weights` are by unit. Fisher, "The design of experiments", 1935; for retrieval: Smucker, Allan, Carterette,
/// CIKM 2007. Throws ArgumentError where there are no resamples or no units.
double randomisation_p_value(const Eigen::VectorXd& differences, const Eigen::VectorXd& weights,
                             const ResamplingOptions& options = {});

/// The answer of a paired t-test.
struct PairedT {
  double t = 0;  ///< infinite where all differences are equal and not 0
  int degrees_of_freedom = 0;
  double p = 1;  ///< two-sided; 1 where all differences are 0
};

/// Student's t-test of the mean of paired differences against 0, two-sided. "Student", Biometrika 6, 1908. It takes the
/// differences as independent, and their mean as normally distributed, which for values between 0 and 1 with many equal
/// ones holds from some dozens on. Throws ArgumentError where there are fewer than two.
PairedT paired_t_test(const Eigen::VectorXd& differences);

/// Randomised Tukey HSD ("honestly significant differences"): p-values of all pairs of methods at once, methods x
/// methods, 1 on the diagonal. In each of B resamples the methods' values are shuffled within every unit, and the
/// largest difference of any two averages is kept; the p-value of a pair is (1 + #) / (B + 1), where # counts those
/// that are at least as large as the pair's own difference. No further correction is needed. Carterette, "Multiple
/// testing in statistical analysis of systems-based information retrieval experiments", ACM TOIS 30, 2012. Throws
/// ArgumentError where there are no resamples or no units.
Eigen::MatrixXd tukey_hsd_p_values(const Units& units, const ResamplingOptions& options = {});

/// The p-values of several tests, adjusted so that calling those below alpha significant goes wrong anywhere with a
/// probability of at most alpha, whatever depends on what: with p-values in ascending order, the i-th of m becomes the
/// largest of (m - j + 1) p_j for j <= i, at most 1. Holm, "A simple sequentially rejective multiple test procedure",
/// Scandinavian Journal of Statistics 6, 1979.
std::vector<double> holm_adjusted(std::span<const double> p_values);

/// Cohen's d for paired differences (d_z): their mean over their standard deviation, that of a sample. About 0.2 is
/// called small, 0.5 medium, 0.8 large. 0 where all differences are 0, infinite where they are equal and not 0. Cohen,
/// "Statistical power analysis for the behavioral sciences", 1988, section 2.3. Unlike a p-value it does not grow with
/// the number of queries. Throws ArgumentError where there are fewer than two.
double effect_size(const Eigen::VectorXd& differences);

/// On how many queries the first of two methods has the larger value, the same value, the smaller one.
struct WinTieLoss {
  Eigen::Index wins = 0;
  Eigen::Index ties = 0;
  Eigen::Index losses = 0;
};

/// Counts by the sign of the differences, first method minus second.
WinTieLoss win_tie_loss(const Eigen::VectorXd& differences);

}  // namespace shapegauge

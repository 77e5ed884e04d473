// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/metrics/significance_tests.h"

namespace shapegauge {

/// Significance test of the difference between two methods.
/// - randomisation: randomisation_p_value(). t: paired_t_p_value().
/// - bootstrap: the p-value is the frequency with which the difference of bootstrap averages is at least as far from
///   the observed difference as the observed difference is from 0 (Efron and Tibshirani 1993, section 16.4).
enum class PairTest { randomisation, t, bootstrap };
template <>
inline constexpr std::array<std::string_view, 3> words_of<PairTest>{"randomisation", "t", "bootstrap"};

/// Options of compare_methods(): significance test, resampling unit, average, confidence level, compared pairs.
struct ComparisonOptions {
  PairTest test = PairTest::randomisation;          ///< significance test of each pair of methods
  ResamplingUnit blocks = ResamplingUnit::queries;  ///< unit of resampling: query or class
  Average average = Average::micro;                 ///< average over queries (micro) or over classes (macro)
  double confidence = 0.95;                         ///< confidence level of the intervals
  std::optional<std::size_t> reference{};  ///< index of the method to compare with each other one; all pairs if not set
  ResamplingOptions resampling{};          ///< number of resamples and seed
};

/// Names, bounds and help texts of the members of ComparisonOptions other than `reference`.
inline constexpr std::array comparison_table = {
    option_of<&ComparisonOptions::test>("test", "Significance test of each pair."),
    option_of<&ComparisonOptions::blocks>(
        "blocks", "Unit of resampling: queries (to generalise to other queries) or classes (to other classes)."),
    option_of<&ComparisonOptions::average>("average", "Average over queries (micro) or over classes (macro)."),
    option_of<&ComparisonOptions::confidence>("confidence", confidence_bounds, "Confidence level of intervals."),
    nested_option<&ComparisonOptions::resampling, resampling_table, 0>(),
    nested_option<&ComparisonOptions::resampling, resampling_table, 1>(),
};

/// Difference between two methods with its significance; part of a MethodComparison.
struct PairDifference {
  std::size_t first = 0;          ///< index of the first method
  std::size_t second = 0;         ///< index of the second method
  double difference = 0;          ///< average score of `first` minus that of `second`
  ConfidenceInterval interval{};  ///< bootstrap confidence interval of `difference`
  double p = 1;                   ///< p-value of ComparisonOptions::test, not corrected for multiple tests
  double p_holm = 1;              ///< `p` with Holm's correction for all pairs of the comparison
  double p_tukey = 1;             ///< p-value of the randomised Tukey HSD test of all methods
  double p_classes = 1;    ///< p-value for further classes (class_p_value()), with Holm's correction for all pairs
  double effect_size = 0;  ///< Cohen's d of the differences of the resampling units (effect_size())
  WinTieLoss queries{};    ///< number of queries on which `first` is better, equal and worse
};

/// Comparison of two or more methods by one measure; result of compare_methods().
struct MethodComparison {
  Eigen::VectorXd averages;                   ///< average score of each method
  std::vector<ConfidenceInterval> intervals;  ///< bootstrap confidence interval of each average
  std::vector<PairDifference> pairs;          ///< compared pairs of methods
  Eigen::Index units = 0;                     ///< number of resampling units: classes or queries
  Eigen::Index classes = 0;                   ///< number of classes of the queries
};

/// Returns the smallest p-value that the test of a pair of methods can have with a number of resampling units; 0 for
/// the t-test, which has no bound. Randomisation exchanges two methods in n units in 2^n ways, half of which differ by
/// their sign only. With B resamples no p-value is below 1 / (B + 1).
double min_attainable_p_value(const ComparisonOptions& options, Eigen::Index units);

/// Returns the two-sided p-value of the difference between two methods for further classes, of which those of the data
/// set are treated as a random sample (docs/notes/significance.md). differences[i] is the difference for query i,
/// classes[i] the class of the query. Student's t-test of the class means of the differences, with equal weights. 1 for
/// one class, or if the average over queries and the mean over classes have different signs; 2^(1 - n) for n classes
/// with equal mean differences.
double class_p_value(const Eigen::VectorXd& differences, std::span<const int> classes);

/// Returns the smallest effect size (Cohen's d of the class means) for which class_p_value() can be significant at
/// `alpha` after Holm's correction for `pairs` pairs of methods. Infinite for one class.
double min_class_effect(std::size_t classes, std::size_t pairs, double alpha);

/// Compares methods by their scores on the same queries: per_query is queries x methods, classes[i] the class of query
/// i. Throws ArgumentError for fewer than two methods or two units, a score that is not finite, and a reference or an
/// option out of range.
MethodComparison compare_methods(const Eigen::MatrixXd& per_query, std::span<const int> classes,
                                 const ComparisonOptions& options = {});

}  // namespace shapegauge

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

/// Significance test of a pair of methods. bootstrap: the p-value is the frequency with which a bootstrap average
/// differs from the observed difference by at least as much as that differs from 0 (Efron and Tibshirani 1993, section
/// 16.4).
enum class PairTest { randomisation, t, bootstrap };
template <>
inline constexpr std::array<std::string_view, 3> words_of<PairTest>{"randomisation", "t", "bootstrap"};

/// Options of a comparison.
struct ComparisonOptions {
  PairTest test = PairTest::randomisation;
  ResamplingUnit blocks = ResamplingUnit::queries;
  Average average = Average::micro;
  double confidence = 0.95;
  std::optional<std::size_t> reference{};  ///< method that is compared with each other one; all pairs if not set
  ResamplingOptions resampling{};
};

/// Parameters of ComparisonOptions.
inline constexpr std::array comparison_table = {
    option_of<&ComparisonOptions::test>("test", "Significance test of each pair."),
    option_of<&ComparisonOptions::blocks>(
        "blocks", "Unit of resampling: queries (claims about these classes), or classes (about classes like these)."),
    option_of<&ComparisonOptions::average>("average", "Average over queries (micro) or over classes (macro)."),
    option_of<&ComparisonOptions::confidence>("confidence", confidence_bounds, "Confidence level of intervals."),
    nested_option<&ComparisonOptions::resampling, resampling_table, 0>(),
    nested_option<&ComparisonOptions::resampling, resampling_table, 1>(),
};

/// Difference between two methods, first minus second, with its significance.
struct PairDifference {
  std::size_t first = 0;
  std::size_t second = 0;
  double difference = 0;          ///< of the averages
  ConfidenceInterval interval{};  ///< of the difference
  double p = 1;
  double p_holm = 1;       ///< Holm's correction for all pairs of this comparison
  double p_tukey = 1;      ///< randomised Tukey HSD of all methods
  double p_classes = 1;    ///< class_p_value(), with Holm's correction for all pairs
  double effect_size = 0;  ///< of the units' differences
  WinTieLoss queries{};
};

/// Comparison of two or more methods by one measure.
struct MethodComparison {
  Eigen::VectorXd averages;                   ///< per method
  std::vector<ConfidenceInterval> intervals;  ///< of the averages
  std::vector<PairDifference> pairs;
  Eigen::Index units = 0;  ///< number of classes or queries
  Eigen::Index classes = 0;
};

/// Returns the smallest possible p-value of a pair's test for a number of units. Randomisation exchanges two methods in
/// n units in 2^n ways, half of which differ by their sign only. With B resamples no p-value is below 1 / (B + 1). 0 if
/// there is no bound (t).
double smallest_p_value(const ComparisonOptions& options, Eigen::Index units);

/// Returns the p-value of the claim that a difference holds for classes like these: Student's t-test of the mean
/// differences of the classes, all of equal weight, in the direction of the average over the queries. The classes are
/// taken as a random sample (docs/notes/significance.md). 1 for one class, or if the average over queries and the mean
/// over classes have different signs; 2^(1 - n) for n classes with equal differences. `differences` are by query.
double class_p_value(const Eigen::VectorXd& differences, std::span<const int> classes);

/// Returns the smallest effect size of class means whose class_p_value() can be significant at `alpha` after Holm's
/// correction for a number of pairs. Infinite for one class.
double min_class_effect(std::size_t classes, std::size_t pairs, double alpha);

/// Compares methods by their values on the same queries: per_query is queries x methods, classes[i] the class of query
/// i. Throws ArgumentError for fewer than two methods or two units, a value that is not finite, and a reference or an
/// option out of range.
MethodComparison compare_methods(const Eigen::MatrixXd& per_query, std::span<const int> classes,
                                 const ComparisonOptions& options = {});

}  // namespace shapegauge

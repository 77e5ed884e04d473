// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/random_numbers.h"

namespace shapegauge {

/// Unit of bootstrap resampling and of randomisation tests.
///
/// - classes: all queries of a class together. Supports claims about further classes, of which those of the data set
///   are treated as a random sample.
/// - queries: each query separately. Supports only claims about further queries of the same classes: scores of one
///   class are correlated, so that many queries of a class say little about other classes.
enum class ResamplingUnit { classes, queries };
template <>
inline constexpr std::array<std::string_view, 2> words_of<ResamplingUnit>{"classes", "queries"};

/// Average of scores: the mean over queries (micro) or the mean of the class means (macro).
enum class Average { micro, macro };
template <>
inline constexpr std::array<std::string_view, 2> words_of<Average>{"micro", "macro"};

/// Options of bootstrap and randomisation tests. The same seed gives the same result for any number of threads.
struct ResamplingOptions {
  int resamples = 10000;   ///< number of bootstrap samples or of random exchanges of methods
  std::uint64_t seed = 1;  ///< seed of the random numbers
};

/// Names, bounds and help texts of the members of ResamplingOptions.
inline constexpr std::array resampling_table = {
    option_of<&ResamplingOptions::resamples>("resamples", {.low = 1, .high = 10'000'000},
                                             "Number of bootstrap and randomisation resamples."),
    option_of<&ResamplingOptions::seed>("seed", seed_bounds, "Seed of random numbers; equal seeds give equal results."),
};

/// Valid confidence levels of confidence intervals.
inline constexpr Bounds confidence_bounds{.low = 0.5, .high = 0.9999};

/// Returns the significance level 1 - confidence without its rounding error, which would make 1 - 0.9 less than a
/// p-value of 0.1.
double significance_level(double confidence);

/// Mean scores of methods per resampling unit (a class or a query), and the weights of the units.
struct UnitValues {
  Eigen::MatrixXd values;   ///< units x methods: mean score of each method over the queries of each unit
  Eigen::VectorXd weights;  ///< weight of each unit in the average; the sum is 1
};

/// Averages the scores `per_query` (queries x methods) over the queries of each unit. classes[i] is the class of query
/// i. Units that are classes are in order of first appearance, so that random draws do not depend on class numbers.
/// Throws ArgumentError without queries and unless `classes` has one entry per query.
UnitValues unit_values_of(const Eigen::MatrixXd& per_query, std::span<const int> classes, ResamplingUnit unit,
                          Average average);

/// Returns the average of each method: the weighted mean of its unit values.
Eigen::VectorXd averages_of(const UnitValues& units);

/// Returns n w_i d_i for each of n units, with the difference d_i between two methods and the weight w_i. The plain
/// mean of these contributions is the weighted mean of the differences.
Eigen::VectorXd contributions(const Eigen::VectorXd& differences, const Eigen::VectorXd& weights);

/// Lower and upper bound of a confidence interval.
struct ConfidenceInterval {
  double low = 0;   ///< lower bound of the interval
  double high = 0;  ///< upper bound of the interval
};

/// Confidence intervals of the averages of an Evaluation. Both vectors have one interval per measure, or none if
/// intervals were not computed.
struct EvaluationIntervals {
  double confidence = 0.95;               ///< confidence level of the intervals
  std::vector<ConfidenceInterval> micro;  ///< intervals of Evaluation::micro
  std::vector<ConfidenceInterval> macro;  ///< intervals of Evaluation::macro
};

/// Computes bootstrap averages (resamples x methods): weighted means of as many units as there are, drawn with
/// replacement. All methods use the same draws. Efron and Tibshirani, "An introduction to the bootstrap", 1993. Throws
/// ArgumentError for options out of range.
Eigen::MatrixXd bootstrap_averages(const UnitValues& units, const ResamplingOptions& options = {});

/// Computes two-sided bootstrap confidence intervals of the averages, one per method: percentiles of
/// bootstrap_averages(), widened by sqrt(n / (n - 1)) and Student's t for the small number of units n (Hesterberg,
/// "What teachers should know about the bootstrap", The American Statistician 69, 2015, section 3.2). If all units have
/// the same value, the interval has zero width. Throws ArgumentError for fewer than two units, and for a confidence or
/// options out of range.
std::vector<ConfidenceInterval> bootstrap_intervals(const UnitValues& units, double confidence = 0.95,
                                                    const ResamplingOptions& options = {});

/// Computes the same confidence intervals as bootstrap_intervals() from `resampled`, the result of bootstrap_averages()
/// for `units` resampling units. Throws ArgumentError for fewer than two units and for a confidence out of range.
std::vector<ConfidenceInterval> percentile_intervals(const Eigen::MatrixXd& resampled, Eigen::Index units,
                                                     double confidence);

}  // namespace shapegauge

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

/// Unit of resampling and randomisation.
///
/// classes: all queries of a class together, for claims about classes like these, which are a random sample. queries:
/// each query separately, for claims about further queries of these classes. These are weaker: scores of one class are
/// correlated, so that many queries of a class say little about other classes.
enum class ResamplingUnit { classes, queries };
template <>
inline constexpr std::array<std::string_view, 2> words_of<ResamplingUnit>{"classes", "queries"};

/// Averaging over queries (micro) or over the means of classes (macro).
enum class Average { micro, macro };
template <>
inline constexpr std::array<std::string_view, 2> words_of<Average>{"micro", "macro"};

/// Options of randomised statistics. The same seed gives the same result for any number of threads.
struct ResamplingOptions {
  int resamples = 10000;
  std::uint64_t seed = 1;
};

/// Parameters of ResamplingOptions.
inline constexpr std::array resampling_table = {
    option_of<&ResamplingOptions::resamples>("resamples", {.low = 1, .high = 10'000'000}, "Number of resamples."),
    option_of<&ResamplingOptions::seed>("seed", seed_bounds, "Seed of random numbers."),
};

/// Valid confidence levels of intervals.
inline constexpr Bounds confidence_bounds{.low = 0.5, .high = 0.9999};

/// Returns 1 - confidence without its rounding error, which would make 1 - 0.9 less than a p-value of 0.1.
double significance_level(double confidence);

/// Values of methods by independent unit, a class or a query.
struct UnitValues {
  Eigen::MatrixXd values;   ///< units x methods: means over the unit's queries
  Eigen::VectorXd weights;  ///< weight of each unit in the average; sum 1
};

/// Aggregates a table queries x methods by unit. classes[i] is the class of query i. Classes are in order of first
/// appearance, which makes random draws independent of their numbering. Throws ArgumentError without queries and for a
/// wrong number of classes.
UnitValues units_of(const Eigen::MatrixXd& per_query, std::span<const int> classes, ResamplingUnit unit,
                    Average average);

/// Returns the average of each method: the weighted mean of its units.
Eigen::VectorXd averages_of(const UnitValues& units);

/// Returns each unit's contribution to the average of `differences` (by unit), times the number of units. The plain
/// mean of the contributions is the average.
Eigen::VectorXd contributions(const Eigen::VectorXd& differences, const Eigen::VectorXd& weights);

/// Confidence interval.
struct ConfidenceInterval {
  double low = 0;
  double high = 0;
};

/// Confidence intervals of an evaluation's averages, by measure; may be empty.
struct EvaluationIntervals {
  double confidence = 0.95;
  std::vector<ConfidenceInterval> micro;
  std::vector<ConfidenceInterval> macro;
};

/// Draws `options.resamples` bootstrap samples of the units with replacement and computes their weighted means
/// (resamples x methods). All methods use the same draws. Efron and Tibshirani, "An introduction to the bootstrap",
/// 1993.
Eigen::MatrixXd bootstrap_averages(const UnitValues& units, const ResamplingOptions& options = {});

/// Computes two-sided bootstrap confidence intervals of the averages, by method: percentiles of bootstrap_averages(),
/// widened by sqrt(n / (n - 1)) and Student's t for the small number of units n (Hesterberg, "What teachers should know
/// about the bootstrap", The American Statistician 69, 2015, section 3.2). If all units have the same value the
/// interval has no width: the data then do not show any variation. Throws ArgumentError for fewer than two units, and
/// for a confidence or options out of range.
std::vector<ConfidenceInterval> bootstrap_intervals(const UnitValues& units, double confidence = 0.95,
                                                    const ResamplingOptions& options = {});

/// Computes the intervals from existing bootstrap averages of `units` units.
std::vector<ConfidenceInterval> percentile_intervals(const Eigen::MatrixXd& resampled, Eigen::Index units,
                                                     double confidence);

}  // namespace shapegauge

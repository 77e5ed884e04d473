#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// What is resampled, or exchanged, as a whole.
///
/// classes: all queries of a class together. The queries of one matrix are not independent: those of a class look for
/// each other, so one model that is far from the others of its class spoils the answers to all of them. What can be
/// taken as independent, and as drawn from a larger world, are the classes. queries: each query by itself, as if they
/// were independent: intervals come out too narrow and tests too eager. For comparison with scores that were made so.
enum class Blocks { classes, queries };

/// Means over queries, or over the means of classes.
enum class Average { micro, macro };

/// The names in files and options: "classes", "queries"; "micro", "macro". And back.
/// @{
std::string name_of(Blocks blocks);
std::optional<Blocks> blocks_of(std::string_view name);
std::vector<std::string> blocks_names();
std::string name_of(Average average);
std::optional<Average> average_of(std::string_view name);
std::vector<std::string> average_names();
/// @}

/// Settings of statistics that draw at random. The same seed gives the same answer for any number of threads.
struct ResamplingOptions {
  int resamples = 10000;
  std::uint64_t seed = 1;
};

/// Values of methods by independent unit: a class, or a query.
struct Units {
  Eigen::MatrixXd values;   ///< units x methods: means over the unit's queries
  Eigen::VectorXd weights;  ///< weight of each unit in the average; they sum to 1
};

/// The units of a table queries x methods. classes[i] is the class of query i; classes are in the order in which the
/// queries have them, so that what is drawn does not depend on how they are numbered. Throws ArgumentError
/// where there are no queries or not as many classes.
Units units_of(const Eigen::MatrixXd& per_query, std::span<const int> classes, Blocks blocks, Average average);

/// The average of each method: the weighted mean of its units.
Eigen::VectorXd averages_of(const Units& units);

/// What each unit adds to the average of `differences` (by unit), times the number of units: numbers whose plain mean
/// is the average.
Eigen::VectorXd contributions(const Eigen::VectorXd& differences, const Eigen::VectorXd& weights);

/// An interval that holds the true value with a given confidence.
struct ConfidenceInterval {
  double low = 0;
  double high = 0;
};

/// The averages of `options.resamples` data sets of as many units each, drawn from the units with replacement
/// (resamples x methods): of each the weighted mean of what was drawn. All methods see the same draws. Efron and
/// Tibshirani, "An introduction to the bootstrap", 1993.
Eigen::MatrixXd bootstrap_averages(const Units& units, const ResamplingOptions& options = {});

/// Two-sided bootstrap intervals of the averages, by method: percentiles of bootstrap_averages, a little further out
/// than the confidence says, by sqrt(n / (n - 1)) and Student's t, which makes up for drawing from a sample of only n
/// units (Hesterberg, "What teachers should know about the bootstrap", The American Statistician 69, 2015,
/// section 3.2). Where all units have the same value the interval has no width: the data then say nothing about how
/// values vary. Throws ArgumentError: fewer than two units, no resamples, a confidence that is not between 0
/// and 1.
std::vector<ConfidenceInterval> bootstrap_intervals(const Units& units, double confidence = 0.95,
                                                    const ResamplingOptions& options = {});

/// The same intervals from averages that were drawn before, of `units` units.
std::vector<ConfidenceInterval> percentile_intervals(const Eigen::MatrixXd& resampled, Eigen::Index units,
                                                     double confidence);

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/metrics/significance_tests.h"

namespace shapegauge {

/// The test that gives the p-value of a pair. bootstrap: how often a bootstrap average differs from the observed
/// difference by at least as much as that differs from 0 (Efron and Tibshirani 1993, section 16.4).
enum class PairTest { randomisation, t, bootstrap };

/// The name in files and options: "randomization", "t" or "bootstrap"; and back.
/// @{
std::string name_of(PairTest test);
std::optional<PairTest> pair_test_of(std::string_view name);
std::vector<std::string> pair_test_names();
/// @}

/// Settings of a comparison.
struct ComparisonOptions {
  PairTest test = PairTest::randomisation;
  Blocks blocks = Blocks::classes;
  Average average = Average::micro;
  double confidence = 0.95;
  std::optional<std::size_t> reference{};  ///< compare this method with each other; nothing: all pairs
  ResamplingOptions resampling{};
};

/// What is known of the difference between two methods, first minus second.
struct PairDifference {
  std::size_t first = 0;
  std::size_t second = 0;
  double difference = 0;          ///< of the averages
  ConfidenceInterval interval{};  ///< of the difference
  double p = 1;
  double p_holm = 1;       ///< Holm's correction for all pairs of this comparison
  double p_tukey = 1;      ///< randomised Tukey HSD of all methods
  double effect_size = 0;  ///< of the units' differences
  WinTieLoss queries{};
};

/// Two or more methods under one measure.
struct MethodComparison {
  Eigen::VectorXd averages;                   ///< by method
  std::vector<ConfidenceInterval> intervals;  ///< of the averages
  std::vector<PairDifference> pairs;
  Eigen::Index units = 0;  ///< how many classes, or queries, everything rests on
};

/// The smallest p-value that the test of a pair can give over so many units: randomisation exchanges two methods in n
/// units in 2^n ways, half of which differ by their sign only; and with B resamples nothing is below 1 / (B + 1). 0
/// where there is no bound (t).
double smallest_p_value(const ComparisonOptions& options, Eigen::Index units);

/// Compares methods by their values on the same queries: per_query is queries x methods, classes[i] the class of query
/// i. Throws ArgumentError: fewer than two methods or two units, a value that is not finite, a reference that
/// is no method.
MethodComparison compare_methods(const Eigen::MatrixXd& per_query, std::span<const int> classes,
                                 const ComparisonOptions& options = {});

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/metrics/bootstrap.h"

namespace shapegauge {

/// Options of standings_of(): resampling unit, average, confidence level, and whether to test significance.
struct StandingOptions {
  ResamplingUnit blocks = ResamplingUnit::queries;  ///< unit of resampling: query or class
  Average average = Average::micro;                 ///< average over queries (micro) or over classes (macro)
  double confidence = 0.95;        ///< confidence level of intervals; significance level 1 - confidence
  ResamplingOptions resampling{};  ///< number of resamples and seed
  bool tested = true;              ///< false: averages and ranks only, no intervals; no methods differ significantly
};

/// Average and rank of a method among others by one measure, with confidence intervals; see standings_of().
struct MethodStanding {
  double average = 0;                            ///< average score over queries or classes
  std::optional<ConfidenceInterval> interval{};  ///< confidence interval of `average`; none if untested or for one unit
  std::size_t rank = 1;  ///< 1 + the number of methods with a larger average, see are_equal_scores()
  /// Confidence interval of the rank: from 1 + the number of significantly better methods to the number of methods
  /// minus the significantly worse ones. Mogstad, Romano, Shaikh, Wilhelm, "Inference for ranks with applications to
  /// mobility across neighbourhoods and academic achievement across countries", Review of Economic Studies 91, 2024.
  /// @{
  std::size_t best_rank = 1;   ///< smallest rank of the interval
  std::size_t worst_rank = 1;  ///< largest rank of the interval
  /// @}
  std::string letters;  ///< letters of compact_letters(): methods that share one do not differ significantly
};

/// Computes the standings of one or more methods by their scores on the same queries: per_query is queries x methods,
/// classes[i] the class of query i. Two methods differ significantly if the p-value of tukey_hsd_p_values() is at most
/// 1 - confidence; with fewer than two units, no methods differ. The result does not depend on the number of threads.
/// Throws ArgumentError without methods or queries, and for a score that is not finite.
std::vector<MethodStanding> standings_of(const Eigen::MatrixXd& per_query, std::span<const int> classes,
                                         const StandingOptions& options = {});

}  // namespace shapegauge

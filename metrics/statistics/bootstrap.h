#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/metrics/statistics/units.h"

namespace shapegauge {

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
/// values vary. Throws std::invalid_argument: fewer than two units, no resamples, a confidence that is not between 0
/// and 1.
std::vector<ConfidenceInterval> bootstrap_intervals(const Units& units, double confidence = 0.95,
                                                    const ResamplingOptions& options = {});

/// The same from averages that were drawn before, of n units.
std::vector<ConfidenceInterval> percentile_intervals(const Eigen::MatrixXd& resampled, Eigen::Index units,
                                                     double confidence);

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "shapegauge/core/sdf/scalar_field.h"

namespace shapegauge {

/// To be raised with every change of histogram() or its smoothing that changes a bin: what a cache holds of earlier
/// versions is then computed anew.
inline constexpr int histogram_version = 1;

/// An interval of values.
struct Interval {
  double low = 0;
  double high = 1;
};

/// Settings of a weighted histogram (the design, section 3).
struct HistogramOptions {
  int bins = 80;
  double smoothing_bins = 0;  ///< standard deviation of a Gaussian (smooth_gaussian), in bins, at most bins; 0: none
};

/// Smallest and largest finite value of positive weight; nothing where there is none.
std::optional<Interval> value_range(const ScalarField& field);

/// The smallest interval around all of the intervals. Throws std::invalid_argument where there are none.
Interval enclosing_interval(std::span<const Interval> intervals);

/// Histogram of the field's values over the range, each value counted by its weight, normalised to sum 1. Bin b holds
/// low + [b, b + 1) * width / bins, the last bin also `high`. Values beyond the range, infinite ones too, count in the
/// first or last bin; NaN values and zero weights do not count. A range of no width puts all in the first bin. Throws
/// std::invalid_argument where no value counts, values and weights differ in number, a weight is negative or not
/// finite, or the range or an option is out of range.
Eigen::VectorXf histogram(const ScalarField& field, const Interval& range, const HistogramOptions& options);

}  // namespace shapegauge

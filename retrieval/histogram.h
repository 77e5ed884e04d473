// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Cache version of histogram() and its smoothing, to increment when results change; see docs/manual/cache.md.
inline constexpr int histogram_version = 2;

/// Closed interval [low, high] of a field's values.
struct Interval {
  double low = 0;   ///< lower end of the interval
  double high = 1;  ///< upper end of the interval
};

/// Options of a weighted histogram (docs/reference/definitions.md#histograms).
struct HistogramOptions {
  int bins = 80;  ///< number of bins of equal width
  double smoothing_bins =
      0;  ///< standard deviation of Gaussian smoothing (smooth_gaussian()), in bins, at most `bins`; 0 for none
};

/// Names, bounds and help texts of the members of HistogramOptions.
inline constexpr std::array histogram_table = {
    option_of<&HistogramOptions::bins>("bins", {.low = 1, .high = 100'000}, "Number of bins."),
    with_unit("bins", option_of<&HistogramOptions::smoothing_bins>(
                          "smoothing_bins", {.low = 0, .high = 1000},
                          "Standard deviation of Gaussian smoothing, at most the number of bins; 0: none.")),
};

/// Returns the smallest and largest finite value of positive weight of a field; nothing if there is no such value.
std::optional<Interval> value_range(const ScalarField& field);

/// Returns true if a range is no wider than rounding: 1e-9 of the larger magnitude of its ends.
bool is_constant(const Interval& range);

/// Returns the smallest interval that contains all of the intervals. Throws ArgumentError if there are none.
Interval enclosing_interval(std::span<const Interval> intervals);

/// Computes the weighted histogram of a field's values over a range, normalised to sum 1. Bin b covers low + [b, b + 1)
/// * width / bins; the last bin includes `high`. Values beyond the range, including infinite ones, count in the first
/// or last bin; NaN values and zero weights are ignored. If the range is_constant(), all values count in the first bin.
/// Throws ArgumentError if there is no valid value, for different numbers of values and weights, for a weight that is
/// negative or not finite, and for a range or an option out of range.
Eigen::VectorXf histogram(const ScalarField& field, const Interval& range, const HistogramOptions& options);

/// Convolves a histogram with a Gaussian whose standard deviation is given in bins. The kernel is sampled at whole bins
/// up to four standard deviations and normalised to sum 1. The histogram is reflected at both ends (c b a | a b c | c b
/// a), which preserves its sum and uniform histograms. This is the convention of scipy.ndimage.gaussian_filter1d with
/// mode "reflect". Throws ArgumentError for an empty histogram and for a standard deviation that is not between 0 (no
/// smoothing) and the number of bins.
Eigen::VectorXd smooth_gaussian(const Eigen::VectorXd& histogram, double standard_deviation);

/// Concatenates histograms of several fields of one shape and normalises the sum to 1. Each histogram keeps its
/// fraction of the total: k histograms that sum to 1 have a weight of 1/k each, whatever their numbers of bins, and the
/// L1 distance of two such signatures is the mean of the histograms' distances. To change a histogram's weight,
/// multiply the histogram beforehand. Throws ArgumentError if there are no histograms, if an entry is negative or not
/// finite, or if all are 0.
Eigen::VectorXf concatenate(std::span<const Eigen::VectorXf> parts);

/// Concatenates histograms of several fields of many shapes. Each of `parts` has the histograms of one field, one row
/// per shape; row i of the result concatenates the rows i. Throws ArgumentError as concatenate() of one shape does,
/// and for `parts` with different numbers of rows.
Signatures concatenate(std::span<const Signatures> parts);

}  // namespace shapegauge

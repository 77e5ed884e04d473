#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Part of cache keys. To be raised with every change of histogram() or its smoothing that changes a bin.
inline constexpr int histogram_version = 1;

/// An interval of values.
struct Interval {
  double low = 0;
  double high = 1;
};

/// Settings of a weighted histogram (docs/reference/definitions.md#histograms).
struct HistogramOptions {
  int bins = 80;
  double smoothing_bins = 0;  ///< standard deviation of a Gaussian (smooth_gaussian), in bins, at most bins; 0: none
};

/// Smallest and largest finite value of positive weight; nothing where there is none.
std::optional<Interval> value_range(const ScalarField& field);

/// The smallest interval around all of the intervals. Throws ArgumentError where there are none.
Interval enclosing_interval(std::span<const Interval> intervals);

/// Histogram of the field's values over the range, each value counted by its weight, normalised to sum 1. Bin b holds
/// low + [b, b + 1) * width / bins, the last bin also `high`. Values beyond the range, infinite ones too, count in the
/// first or last bin; NaN values and zero weights do not count. A range of no width puts all in the first bin. Throws
/// ArgumentError where no value counts, values and weights differ in number, a weight is negative or not
/// finite, or the range or an option is out of range.
Eigen::VectorXf histogram(const ScalarField& field, const Interval& range, const HistogramOptions& options);

/// The histogram convolved with a Gaussian whose standard deviation is given in bins: the kernel is sampled at whole
/// bins up to four standard deviations and normalised to sum 1. At both ends the histogram is continued by its mirror
/// image (c b a | a b c | c b a), so no mass is lost, the sum stays what it was, and a uniform histogram stays uniform.
/// That is the convention of scipy.ndimage.gaussian_filter1d with mode "reflect". Throws ArgumentError for an
/// empty histogram and for a standard deviation that is not between 0 (no smoothing) and the number of bins.
Eigen::VectorXd smooth_gaussian(const Eigen::VectorXd& histogram, double standard_deviation);

/// Histograms of several fields of one shape, side by side, divided by their total so that the whole sums to 1. Each
/// part keeps its fraction of the total: k histograms that sum to 1 each weigh 1/k, however many bins they have, and
/// the L1 distance of two such signatures is the mean of the parts' distances. Multiply a part beforehand to give it
/// another weight. Throws ArgumentError where there are no parts, or an entry is negative or not finite, or all
/// are 0.
Eigen::VectorXf concatenate(std::span<const Eigen::VectorXf> parts);

/// The same for many shapes at once: row i is the concatenation of the parts' rows i. Throws ArgumentError as
/// above, and where the parts differ in their number of rows.
Signatures concatenate(std::span<const Signatures> parts);

}  // namespace shapegauge

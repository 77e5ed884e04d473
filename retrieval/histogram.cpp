#include "shapegauge/retrieval/histogram.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "shapegauge/retrieval/gaussian_smoothing.h"

namespace shapegauge {
namespace {

void check_sizes(const ScalarField& field) {
  if (field.values.size() != field.weights.size()) {
    throw std::invalid_argument("a field has " + std::to_string(field.values.size()) + " values but " +
                                std::to_string(field.weights.size()) + " weights");
  }
}

void check_options(const Interval& range, const HistogramOptions& options) {
  if (options.bins < 1) {
    throw std::invalid_argument("a histogram needs at least one bin, not " + std::to_string(options.bins));
  }
  if (!(range.low <= range.high) || !std::isfinite(range.high - range.low)) {
    throw std::invalid_argument("the range of a histogram must be finite and ascending, not [" +
                                std::to_string(range.low) + ", " + std::to_string(range.high) + "]");
  }
}

Eigen::Index bin_of(double value, const Interval& range, int bins) {
  const double width = range.high - range.low;
  if (width == 0) return 0;
  // Clamped before the conversion: an infinite position has no integer.
  const double position = (value - range.low) / width * bins;
  return static_cast<Eigen::Index>(std::clamp(position, 0.0, static_cast<double>(bins - 1)));
}

}  // namespace

std::optional<Interval> value_range(const ScalarField& field) {
  check_sizes(field);
  std::optional<Interval> range;
  for (Eigen::Index i = 0; i < field.values.size(); ++i) {
    const double value = field.values[i];
    if (!std::isfinite(value) || !(field.weights[i] > 0)) continue;
    if (!range) range = Interval{value, value};
    range->low = std::min(range->low, value);
    range->high = std::max(range->high, value);
  }
  return range;
}

Interval enclosing_interval(std::span<const Interval> intervals) {
  if (intervals.empty()) throw std::invalid_argument("no intervals to enclose");
  Interval enclosing = intervals.front();
  for (const Interval& interval : intervals) {
    enclosing.low = std::min(enclosing.low, interval.low);
    enclosing.high = std::max(enclosing.high, interval.high);
  }
  return enclosing;
}

Eigen::VectorXf histogram(const ScalarField& field, const Interval& range, const HistogramOptions& options) {
  check_sizes(field);
  check_options(range, options);
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(options.bins);
  double total = 0;
  for (Eigen::Index i = 0; i < field.values.size(); ++i) {
    const double weight = field.weights[i];
    if (!(weight >= 0) || !std::isfinite(weight)) {
      throw std::invalid_argument("the weight of sample " + std::to_string(i) + " is " + std::to_string(weight) +
                                  "; weights must be finite and not negative");
    }
    if (std::isnan(field.values[i])) continue;
    counts[bin_of(field.values[i], range, options.bins)] += weight;
    total += weight;
  }
  if (!(total > 0)) throw std::invalid_argument("a field without any value of positive weight has no histogram");
  if (!std::isfinite(total)) throw std::invalid_argument("the weights of a field sum to more than a number can hold");
  return smooth_gaussian(counts / total, options.smoothing_bins).cast<float>();
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/histogram.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

void check_sizes(const ScalarField& field) {
  if (field.values.size() != field.weights.size()) {
    throw ArgumentError("a field has " + std::to_string(field.values.size()) + " values but " +
                        std::to_string(field.weights.size()) + " weights");
  }
}

void check_range(const Interval& range) {
  if (!(range.low <= range.high) || !std::isfinite(range.high - range.low)) {
    throw ArgumentError("the range of a histogram must be finite and ascending, not [" + std::to_string(range.low) +
                        ", " + std::to_string(range.high) + "]");
  }
}

Eigen::Index bin_of(double value, const Interval& range, int bins) {
  // Clamped before the conversion: an infinite position has no integer value.
  const double position = (value - range.low) / (range.high - range.low) * bins;
  return static_cast<Eigen::Index>(std::clamp(position, 0.0, static_cast<double>(bins - 1)));
}

}  // namespace

bool is_constant(const Interval& range) {
  constexpr double rounding = 1e-9;
  return range.high - range.low <= rounding * std::max(std::abs(range.low), std::abs(range.high));
}

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
  if (intervals.empty()) throw ArgumentError("an enclosing interval needs at least one interval, and there is none");
  Interval enclosing = intervals.front();
  for (const Interval& interval : intervals) {
    enclosing.low = std::min(enclosing.low, interval.low);
    enclosing.high = std::max(enclosing.high, interval.high);
  }
  return enclosing;
}

Eigen::VectorXf histogram(const ScalarField& field, const Interval& range, const HistogramOptions& options) {
  check_sizes(field);
  check_options("histogram", histogram_table, options);
  check_range(range);
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(options.bins);
  double total = 0;
  const bool is_single_bin = is_constant(range);
  for (Eigen::Index i = 0; i < field.values.size(); ++i) {
    const double weight = field.weights[i];
    if (!(weight >= 0) || !std::isfinite(weight)) {
      throw ArgumentError("the weight of sample " + std::to_string(i) + " is " + std::to_string(weight) +
                          "; weights must be finite and not negative");
    }
    if (std::isnan(field.values[i])) continue;
    counts[is_single_bin ? 0 : bin_of(field.values[i], range, options.bins)] += weight;
    total += weight;
  }
  if (!(total > 0))
    throw ArgumentError("a histogram needs at least one value with a positive weight, and the field has none");
  if (!std::isfinite(total)) throw ArgumentError("the sum of the weights of a field is not finite; reduce the weights");
  return smooth_gaussian(counts / total, options.smoothing_bins).cast<float>();
}

namespace {

constexpr double kernel_reach = 4.0;  // in standard deviations

// Returns the weights of offsets 0, 1, ... reach of the symmetric kernel, whose total is 1.
Eigen::VectorXd half_kernel(double standard_deviation) {
  const auto reach = static_cast<Eigen::Index>(std::lround(kernel_reach * standard_deviation));
  Eigen::VectorXd weights(reach + 1);
  double total = 0;
  for (Eigen::Index offset = 0; offset <= reach; ++offset) {
    const double x = static_cast<double>(offset) / standard_deviation;
    weights[offset] = std::exp(-0.5 * x * x);
    total += offset == 0 ? weights[offset] : 2 * weights[offset];
  }
  return weights / total;
}

// Returns the bin at a position of the reflected continuation of a histogram.
Eigen::Index mirrored_bin(Eigen::Index position, Eigen::Index bins) {
  const Eigen::Index period = 2 * bins;
  const Eigen::Index phase = ((position % period) + period) % period;
  return phase < bins ? phase : period - 1 - phase;
}

}  // namespace

Eigen::VectorXd smooth_gaussian(const Eigen::VectorXd& histogram, double standard_deviation) {
  const Eigen::Index bins = histogram.size();
  if (bins == 0) throw ArgumentError("a histogram without bins cannot be smoothed");
  if (!(standard_deviation >= 0 && standard_deviation <= static_cast<double>(bins))) {
    throw ArgumentError("the smoothing of a histogram must be from 0 to its number of bins (" + std::to_string(bins) +
                        "), not " + std::to_string(standard_deviation));
  }
  if (standard_deviation == 0) return histogram;
  const Eigen::VectorXd kernel = half_kernel(standard_deviation);
  Eigen::VectorXd smoothed(bins);
  for (Eigen::Index bin = 0; bin < bins; ++bin) {
    double sum = kernel[0] * histogram[bin];
    for (Eigen::Index offset = 1; offset < kernel.size(); ++offset) {
      sum +=
          kernel[offset] * (histogram[mirrored_bin(bin - offset, bins)] + histogram[mirrored_bin(bin + offset, bins)]);
    }
    smoothed[bin] = sum;
  }
  return smoothed;
}

namespace {

// Normalises a row of concatenated parts to sum 1.
void normalise(Eigen::Ref<Eigen::RowVectorXf> signature) {
  double total = 0;
  for (Eigen::Index i = 0; i < signature.size(); ++i) {
    const float entry = signature[i];
    if (!(entry >= 0) || !std::isfinite(entry)) {
      throw ArgumentError("entry " + std::to_string(i) + " of a signature is " + std::to_string(entry) +
                          "; only finite entries that are not negative can be concatenated");
    }
    total += entry;
  }
  if (!(total > 0)) throw ArgumentError("a signature of zeros only cannot be normalised");
  signature = (signature.cast<double>() / total).cast<float>();
}

}  // namespace

Signatures concatenate(std::span<const Signatures> parts) {
  if (parts.empty()) throw ArgumentError("no signatures to concatenate");
  Eigen::Index length = 0;
  for (const Signatures& part : parts) {
    if (part.rows() != parts.front().rows()) {
      throw ArgumentError("signatures of " + std::to_string(parts.front().rows()) + " and of " +
                          std::to_string(part.rows()) + " shapes cannot be concatenated");
    }
    length += part.cols();
  }
  Signatures whole(parts.front().rows(), length);
  Eigen::Index column = 0;
  for (const Signatures& part : parts) {
    whole.middleCols(column, part.cols()) = part;
    column += part.cols();
  }
  for (Eigen::Index row = 0; row < whole.rows(); ++row) normalise(whole.row(row));
  return whole;
}

Eigen::VectorXf concatenate(std::span<const Eigen::VectorXf> parts) {
  std::vector<Signatures> rows;
  rows.reserve(parts.size());
  for (const Eigen::VectorXf& part : parts) rows.emplace_back(part.transpose());
  return concatenate(rows).row(0).transpose();
}

}  // namespace shapegauge

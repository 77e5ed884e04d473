// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/joint_histogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/retrieval/l1_distance.h"

namespace shapegauge {

namespace {

constexpr std::string_view name = "joint_histogram";
constexpr std::array joint_histogram_table = {
    option_of<&JointAxis::bins>("bins", {.low = 1, .high = 1000}, "Number of bins of the axis."),
    with_unit("bins", option_of<&JointAxis::smoothing_bins>(
                          "smoothing_bins", {.low = 0, .high = 1000},
                          "Standard deviation of Gaussian smoothing along the axis; 0: none.")),
    option_of<&JointAxis::divide_by_mean>("divide_by_mean", "Divide each shape's values by their mean before binning."),
    option_of<&JointAxis::low>("low", {.low = -1e9, .high = 1e9},
                               "Lower end of the range; smaller values count in the first bin."),
    option_of<&JointAxis::high>("high", {.low = -1e9, .high = 1e9},
                                "Upper end of the range; larger values count in the last bin."),
    option_of<&JointAxis::per_shape>("per_shape", "Use each shape's minimum and maximum instead of low and high."),
    option_of<&JointAxis::over_data_set>("over_data_set",
                                         "Use the data set's minimum and maximum instead of low and high."),
};
constexpr auto joint_histogram_parameters = parameters_of(joint_histogram_table);
constexpr std::array options_table = {
    option_of<&JointHistogramOptions::square_roots>(
        "square_roots", "Compare square roots of bin values, which gives small values more weight."),
};
constexpr auto options_parameters = parameters_of(options_table);

/// Returns the weighted mean of the finite values.
double mean_of(const ScalarField& field) {
  double sum = 0;
  double total = 0;
  for (Eigen::Index i = 0; i < field.values.size(); ++i) {
    if (!std::isfinite(field.values[i]) || !(field.weights[i] > 0)) continue;
    sum += field.weights[i] * field.values[i];
    total += field.weights[i];
  }
  return sum / total;
}

/// Returns the divisor of the values.
double unit_of(const ScalarField& field, bool divide_by_mean) {
  if (!divide_by_mean) return 1;
  const double mean = mean_of(field);
  if (!(mean > 0) || !std::isfinite(mean)) {
    throw ArgumentError("a field can only be divided by its mean where that is positive, not " + std::to_string(mean));
  }
  return mean;
}

void check_axis(const JointAxis& axis) {
  check_options(name, joint_histogram_table, axis);
  if (!(axis.low < axis.high)) {
    throw InputError(
        fmt::format("the range of an axis of a joint histogram must be ascending, not [{}, {}]", axis.low, axis.high));
  }
}

/// Sets the range of an axis to that of some values. The lower end of a constant one becomes that of a unit.
void set_range(JointAxis& axis, const Interval& of_values) {
  axis.low = of_values.low;
  axis.high = is_constant(of_values) ? of_values.low + 1 : of_values.high;
}

/// Returns the axis, with the range of the shape if requested.
JointAxis resolved(JointAxis axis, const ScalarField& field) {
  if (axis.per_shape) set_range(axis, joint_range(field, axis.divide_by_mean));
  check_axis(axis);
  return axis;
}

std::size_t checked_size(std::span<const ScalarField> fields, std::span<const JointAxis> axes) {
  if (fields.size() < 2 || axes.size() != fields.size()) {
    throw ArgumentError("a joint histogram needs two fields or more and an axis for each, not " +
                        std::to_string(fields.size()) + " fields and " + std::to_string(axes.size()) + " axes");
  }
  const Eigen::Index samples = fields.front().values.size();
  for (const ScalarField& field : fields) {
    if (field.values.size() != samples || field.weights.size() != samples) {
      throw ArgumentError("the fields of a joint histogram must be at the same samples; there are " +
                          std::to_string(field.values.size()) + " and " + std::to_string(samples));
    }
  }
  constexpr std::size_t most = 1'000'000;
  std::size_t bins = 1;
  for (const JointAxis& axis : axes) {
    bins *= static_cast<std::size_t>(axis.bins);
    if (bins > most)
      throw ArgumentError("the axes of a joint histogram may have at most " + std::to_string(most) +
                          " bins in all; reduce bins");
  }
  return bins;
}

double checked_weight(const ScalarField& field, Eigen::Index i) {
  const double weight = field.weights[i];
  if (weight >= 0 && std::isfinite(weight)) return weight;
  throw ArgumentError("the weight of sample " + std::to_string(i) + " is " + std::to_string(weight) +
                      "; weights must be finite and not negative");
}

/// Returns the bin of a sample; values out of range are in the outer bins. Nothing where a field has no value.
std::optional<Eigen::Index> bin_of(Eigen::Index sample, std::span<const ScalarField> fields,
                                   std::span<const JointAxis> axes, std::span<const double> units) {
  Eigen::Index bin = 0;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const JointAxis& axis = axes[k];
    const double value = fields[k].values[sample] / units[k];
    if (std::isnan(value)) return std::nullopt;
    const double position = (value - axis.low) / (axis.high - axis.low) * axis.bins;
    const double clamped = std::clamp(position, 0.0, static_cast<double>(axis.bins - 1));
    bin = bin * axis.bins + static_cast<Eigen::Index>(clamped);
  }
  return bin;
}

/// Smooths along one axis, whose adjacent bins are `stride` apart.
void smooth_axis(Eigen::VectorXd& counts, const JointAxis& axis, Eigen::Index stride) {
  const Eigen::Index bins = axis.bins;
  for (Eigen::Index begin = 0; begin < counts.size(); begin += bins * stride) {
    for (Eigen::Index offset = 0; offset < stride; ++offset) {
      Eigen::Map<Eigen::VectorXd, 0, Eigen::InnerStride<>> line(counts.data() + begin + offset, bins,
                                                                Eigen::InnerStride<>(stride));
      line = smooth_gaussian(line, axis.smoothing_bins);
    }
  }
}

}  // namespace

Interval joint_range(const ScalarField& field, bool divide_by_mean) {
  const std::optional<Interval> range = value_range(field);
  if (!range) throw ArgumentError("the range of a field needs a value of positive weight, and the field has none");
  const double unit = unit_of(field, divide_by_mean);
  return {range->low / unit, range->high / unit};
}

Eigen::VectorXf joint_histogram(std::span<const ScalarField> fields, std::span<const JointAxis> axes_as_asked,
                                const JointHistogramOptions& options) {
  const std::size_t bins = checked_size(fields, axes_as_asked);
  std::vector<double> units;
  std::vector<JointAxis> axes;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    axes.push_back(resolved(axes_as_asked[k], fields[k]));
    units.push_back(unit_of(fields[k], axes[k].divide_by_mean));
  }
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(bins));
  double total = 0;
  for (Eigen::Index i = 0; i < fields.front().values.size(); ++i) {
    const double weight = checked_weight(fields.front(), i);
    const std::optional<Eigen::Index> bin = bin_of(i, fields, axes, units);
    if (!bin) continue;
    counts[*bin] += weight;
    total += weight;
  }
  if (!(total > 0) || !std::isfinite(total)) {
    throw ArgumentError("a joint histogram needs a sample at which all fields have a value, and there is none");
  }
  counts /= total;
  Eigen::Index stride = counts.size();
  for (const JointAxis& axis : axes) {
    stride /= axis.bins;
    if (axis.smoothing_bins != 0) smooth_axis(counts, axis, stride);
  }
  if (options.square_roots) counts = counts.cwiseSqrt().eval();
  return counts.cast<float>();
}

namespace {

std::vector<JointAxis> axes_from(const DescriptorSettings& settings) {
  std::vector<JointAxis> axes;
  for (const ParameterValues& of_axis : settings.axes) axes.push_back(options_from(joint_histogram_table, of_axis));
  return axes;
}

/// Validates axes independently of the fields.
void check_axes(const DescriptorSettings& settings) {
  for (const JointAxis& axis : axes_from(settings)) {
    if (!axis.per_shape && !axis.over_data_set) check_axis(axis);
  }
}

/// Returns the data set's ranges, one row per axis.
LearntFeatures learn_ranges(std::span<const DescriptorInput> shapes, const DescriptorSettings& settings) {
  if (shapes.empty()) return {};
  const std::vector<JointAxis> axes = axes_from(settings);
  LearntFeatures ranges = LearntFeatures::Zero(std::ssize(axes), 2);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (!axes[k].over_data_set) continue;
    std::vector<Interval> of_shapes;
    for (const DescriptorInput& shape : shapes) {
      of_shapes.push_back(joint_range(shape.fields[k], axes[k].divide_by_mean));
    }
    const Interval range = enclosing_interval(of_shapes);
    ranges.row(static_cast<Eigen::Index>(k)) << static_cast<float>(range.low), static_cast<float>(range.high);
  }
  return ranges;
}

}  // namespace

Descriptor joint_histogram_descriptor() {
  constexpr std::size_t max_fields = 6;
  return {
      .name = name,
      .description = "Joint histogram of fields, such as diameter and centricity (Gal, Shamir, Cohen-Or 2007).",
      .parameters = options_parameters,
      .axis_parameters = joint_histogram_parameters,
      .min_fields = 2,
      .max_fields = max_fields,
      .version = 2,
      .describe =
          [](const DescriptorInput& input, const LearntFeatures& ranges, const DescriptorSettings& settings) {
            std::vector<JointAxis> axes = axes_from(settings);
            for (std::size_t k = 0; k < axes.size(); ++k) {
              if (!axes[k].over_data_set) continue;
              if (ranges.rows() != std::ssize(axes)) {
                throw InputError(fmt::format("the descriptor {} has no ranges; learn them from shapes first", name));
              }
              const auto row = static_cast<Eigen::Index>(k);
              set_range(axes[k], {.low = ranges(row, 0), .high = ranges(row, 1)});
            }
            return joint_histogram(input.fields, axes, options_from(options_table, settings.values));
          },
      .distance = l1_distance,
      .learn = learn_ranges,
      .learns =
          [](const DescriptorSettings& settings) {
            return std::ranges::any_of(axes_from(settings), &JointAxis::over_data_set);
          },
      .check = check_axes};
}

}  // namespace shapegauge

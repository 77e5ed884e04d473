// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

/// Axis of a joint histogram: the binning of one field's values.
struct JointAxis {
  int bins = 40;  ///< number of bins of the axis
  double smoothing_bins =
      1;  ///< standard deviation of Gaussian smoothing (smooth_gaussian()), in bins, at most `bins`; 0 for none
  bool divide_by_mean = false;  ///< divide the values by their weighted mean first, which makes them invariant to scale
  double low = 0;               ///< lower end of the range, after divide_by_mean; smaller values count in the first bin
  double high = 1;              ///< upper end of the range, after divide_by_mean; larger values count in the last bin
  bool per_shape = false;  ///< use each shape's range of values, not low and high; a constant field is in the first bin
  bool over_data_set = false;  ///< use the data set's range of values; only for joint_histogram_descriptor()
};

/// Conversion of the bins of a joint histogram to features.
struct JointHistogramOptions {
  bool square_roots =
      false;  ///< take square roots of the bins, which increases the effect of small bins (as in Hellinger's distance)
};

/// Computes the range of a field's values, after division by their mean if requested. Throws ArgumentError if there is
/// no valid value, or the mean is not positive.
Interval joint_range(const ScalarField& field, bool divide_by_mean);

/// Computes the joint histogram of fields at the same samples, one axis per field, with the first field's weights,
/// normalised to sum 1. The last axis varies fastest. With diameter and centricity it is the pose-oblivious signature
/// of Gal, Shamir and Cohen-Or (2007). Samples with a NaN value are ignored. Compared by L1.
///
/// For independent fields it is the product of their histograms. Throws InputError for an axis out of range. Throws
/// ArgumentError for less than two fields, fields of different lengths, a wrong number of axes, more than 1,000,000
/// bins, and as histogram() does.
Eigen::VectorXf joint_histogram(std::span<const ScalarField> fields, std::span<const JointAxis> axes,
                                const JointHistogramOptions& options = {});

/// Returns the entry "joint_histogram" of the registry descriptors(). Its parameters are JointHistogramOptions and, for
/// each field, a JointAxis.
Descriptor joint_histogram_descriptor();

}  // namespace shapegauge

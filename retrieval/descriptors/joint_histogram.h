#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "shapegauge/retrieval/histogram.h"

namespace shapegauge {

/// To be raised with every change of joint_histogram() that changes a bin: what a cache holds of earlier versions is
/// then computed anew.
inline constexpr int joint_histogram_version = 1;

/// One axis of a joint histogram: how a field's values become bins.
struct JointAxis {
  int bins = 40;
  double smoothing_bins = 1;    ///< standard deviation of a Gaussian (smooth_gaussian), in bins, at most bins; 0: none
  bool divide_by_mean = false;  ///< the values are first divided by their mean by weight, which no scale then changes
  double low = 0;               ///< the range's ends, after that division; values beyond them count in the outer bins
  double high = 1;
  bool per_shape = false;      ///< each shape's own least and greatest value instead; of a constant field its value and
                               ///< 1 more, so that all of it is in the first bin
  bool over_data_set = false;  ///< those of the data set instead; only descriptor() knows them
};

/// How the bins of a joint histogram become features.
struct JointHistogramOptions {
  bool square_roots = false;  ///< their square roots, so that small shares count more (as in Hellinger's distance)
};

/// The range of a field's values, after division by their mean where that is asked for. Throws ArgumentError
/// where no value counts, or the mean is not positive.
Interval joint_range(const ScalarField& field, bool divide_by_mean);

/// The joint histogram of fields at the same samples, one axis each, by the first field's weights, normalised to sum 1;
/// the last axis varies fastest. Of diameter and centricity it is the pose-oblivious signature of Gal, Shamir and
/// Cohen-Or 2007. A sample counts where all of its values are numbers. Compared by L1.
///
/// On independent fields it is the product of their histograms. Throws InputError for an axis out of range, and
/// ArgumentError for less than two fields, fields that differ in number, axes that are not as many, more than
/// 1,000,000 bins, and as histogram().
Eigen::VectorXf joint_histogram(std::span<const ScalarField> fields, std::span<const JointAxis> axes,
                                const JointHistogramOptions& options = {});

/// Its settings are its options, and those of its axes, one for each field.
Descriptor joint_histogram_descriptor();

}  // namespace shapegauge

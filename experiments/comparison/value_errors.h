#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Values of a field where they are, in the units of the shape's file.
struct PlacedValues {
  Points points;
  Eigen::VectorXd values;  ///< all of them finite
};

/// The values at samples that have one and that stand for some area. Lengths, of the samples and of the values,
/// multiplied by the unit, are those of the result.
PlacedValues placed_values(const Samples& samples, const Eigen::VectorXd& values, double unit);

/// How far a field is from that of the reference: quantiles of |value - reference's value at its sample nearest by|,
/// each sample counting once.
struct ValueErrors {
  double median = 0;                  ///< as a fraction of the reference's diagonal
  double percentile_90 = 0;           ///< as such a fraction
  double relative_median = 0;         ///< of the errors, each divided by the reference's value
  double relative_percentile_90 = 0;  ///< of those
};

/// The errors of the values with respect to the reference's, which are in the same units and place. NaN where either
/// has no values. Runs in the calling TBB arena.
ValueErrors value_errors(const PlacedValues& placed, const PlacedValues& reference, double reference_diagonal);

}  // namespace shapegauge

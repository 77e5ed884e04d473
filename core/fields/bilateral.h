#pragma once

#include <Eigen/Core>
#include <array>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// To be raised with every change of bilateral_smoothing() that changes a value: what a cache holds of earlier versions
/// is then computed anew.
inline constexpr int bilateral_version = 2;

/// Settings of bilateral_smoothing().
struct BilateralOptions {
  int iterations = 1;
  double spatial_width = 0.02;  ///< standard deviation by distance, in square roots of the area
  double value_width = 0.5;     ///< standard deviation by value, in standard deviations of the field
};

/// What may be chosen of BilateralOptions.
inline constexpr std::array bilateral_table = {
    option_of<&BilateralOptions::iterations>("iterations", {.low = 0, .high = 100}, "How many times."),
    option_of<&BilateralOptions::spatial_width>(
        "spatial_width", {.low = 0, .high = 1, .low_open = true},
        "Standard deviation by distance along the surface, in square roots of the area."),
    option_of<&BilateralOptions::value_width>("value_width", {.low = 0, .high = 1e6, .low_open = true},
                                              "Standard deviation by value, in standard deviations of the field."),
};

/// A field at the samples of a shape, smoothed along the surface but not across its steps: each value becomes the mean
/// of those within two spatial widths, weighted by area and by Gaussians of distance and of difference in value (Tomasi
/// and Manduchi 1998; on surfaces, as CGAL smooths the SDF, Shapira et al. 2008).
///
/// Distance is that of paths from sample to sample: over the edges of the faces, the edges of the mesh, or, between
/// points of a cloud and samples of the surface, between 8 nearest neighbours. Values that are not finite take no part
/// and stay as they are. Weights stay. Throws InputError for options out of range, an unusable shape
/// (require_usable()), and samples or a field that are not the shape's.
ScalarField bilateral_smoothing(const Shape& shape, const Samples& samples, ScalarField field,
                                const BilateralOptions& options = {});

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version of bilateral_smoothing(); see docs/manual/cache.md.
inline constexpr int bilateral_version = 2;

/// Options of bilateral_smoothing().
struct BilateralOptions {
  int iterations = 1;           ///< number of passes of the filter
  double spatial_width = 0.02;  ///< standard deviation of the spatial Gaussian, in square roots of the surface area
  double value_width = 0.5;     ///< standard deviation of the value Gaussian, in standard deviations of the field
};

/// Names, bounds and help texts of the parameters in BilateralOptions (option_parameters.h).
inline constexpr std::array bilateral_table = {
    option_of<&BilateralOptions::iterations>("iterations", {.low = 0, .high = 100},
                                             "Number of smoothing passes; 0: none."),
    with_unit("square roots of the area",
              option_of<&BilateralOptions::spatial_width>(
                  "spatial_width", {.low = 0, .high = 1, .low_open = true},
                  "Standard deviation of the spatial Gaussian: larger values smooth over longer distances.")),
    with_unit("standard deviations of the field",
              option_of<&BilateralOptions::value_width>(
                  "value_width", {.low = 0, .high = 1e6, .low_open = true},
                  "Standard deviation of the Gaussian of value differences: larger widths also smooth higher steps.")),
};

/// Smooths a field along the surface with an edge-preserving bilateral filter (Tomasi and Manduchi 1998; on surfaces as
/// CGAL smooths the SDF, Shapira et al. 2008). In each iteration a value becomes the mean of the values within two
/// spatial widths, weighted by area and by Gaussians of distance and value difference.
///
/// Distances are those of shortest paths between samples. The paths follow the dual edges of faces, the edges of the
/// mesh or, for points of a cloud and surface samples, the edges to 8 nearest neighbours. Values that are not finite
/// are ignored and stay unchanged, as do the field's weights. Throws InputError for options out of range, an unusable
/// shape (require_usable()), and samples or a field of another shape.
ScalarField bilateral_smoothing(const Shape& shape, const Samples& samples, ScalarField field,
                                const BilateralOptions& options = {});

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Options of d2().
struct D2Options {
  int points = 1024;   ///< number of surface points; the distances of all pairs are counted
  int bins = 64;       ///< number of histogram bins, from distance 0 to `longest`
  double longest = 3;  ///< upper end of the last bin, in mean distances of all pairs; larger distances count there
};

/// Computes the shape distribution D2 (Osada, Funkhouser, Chazelle, Dobkin 2002): the histogram of distances between
/// pairs of points spread over the surface by area, divided by their mean, normalised to sum 1. Invariant to rotation,
/// scale and meshing. Clouds are described by their points. Compared by L1, the better of the norms in the paper.
///
/// For a sphere the density of distances d is d / (2 R^2) from 0 to 2 R, with the mean 4 R / 3. Throws InputError for
/// options out of range, an unusable shape, and one without two distinct points.
Eigen::VectorXf d2(const Shape& shape, const D2Options& options = {});

/// Returns the entry "d2" of the registry descriptors().
Descriptor d2_descriptor();

}  // namespace shapegauge

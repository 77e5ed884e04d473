// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Options of surflet_pairs().
struct SurfletPairsOptions {
  int distance_bins = 10;       ///< number of bins of the distance between two points
  int angle_bins = 5;           ///< number of bins of each of the three absolute cosines
  double largest_distance = 3;  ///< upper end of the distance axis, in mean distances of all pairs
};

/// Computes the histogram of surflet-pair relations (after Wahl, Hillenbrand, Hirzinger 2003). Surflets are points with
/// normals: the landmarks of the surface proxy. A pair is weighted by the product of the two areas. Its coordinates are
/// the distance, divided by the mean distance of all pairs; the absolute cosine between the normals; and the greater
/// and the smaller absolute cosine between a normal and the line through both points. Absolute values make the
/// histogram independent of the surface's orientation. A pair is distributed over the nearest bins with multilinear
/// weights.
///
/// Returns the square roots of the normalised histogram, distance_bins x angle_bins^3 features, compared by L1. They
/// are invariant to scale, rigid motion and reflection, and robust to slight bending. Throws InputError for options out
/// of range, for a shape whose points all coincide, and as surface_proxy() does.
Eigen::VectorXf surflet_pairs(ProxySource& source, const SurfletPairsOptions& options = {});

/// Returns the entry "surflet_pairs" of the registry descriptors().
Descriptor surflet_pairs_descriptor();

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>

#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Cache version; increment when features change. The version of the proxy is added (version_on_proxy()).
inline constexpr int surflet_pairs_version = 1;

/// Options of surflet_pairs().
struct SurfletPairsOptions {
  int distance_bins = 10;       ///< bins of the distance
  int angle_bins = 5;           ///< bins of each of the three cosines
  double largest_distance = 3;  ///< end of the distance axis, in mean distances
};

/// Histogram of the relations of pairs of surflets, points with their normals (after Wahl, Hillenbrand, Hirzinger
/// 2003). The surflets are the landmarks of the surface proxy; a pair counts by the product of their areas. Its
/// coordinates are the distance, over the mean distance of all pairs; the absolute cosine between the normals; and the
/// greater and the lesser absolute cosine between a normal and the line through both points. Absolute values, because
/// the orientation of a surface need not be known. A pair is shared by the bins whose centres are around it
/// (multilinear weights).
///
/// Returns the square roots of the bins' shares, distance_bins x angle_bins^3 features, compared by L1. Neither scale
/// nor motion nor reflection changes them, and where a shape bends little. Throws InputError for options out of range,
/// for a shape with a single place, and as surface_proxy().
Eigen::VectorXf surflet_pairs(ProxySource& source, const SurfletPairsOptions& options = {});

Descriptor surflet_pairs_descriptor();

}  // namespace shapegauge

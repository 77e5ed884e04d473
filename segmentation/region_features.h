// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>

#include "shapegauge/segmentation/regions.h"

namespace shapegauge {

inline constexpr int region_features = 44;  ///< number of features of two adjacent regions

/// Features of two adjacent regions, from which a PartModel decides whether they are one part; symmetric in the two. In
/// the features' names, "small" and "large" denote the region of smaller and of larger area. Thickness is logarithmic;
/// lengths and areas are relative to the whole surface.
using RegionFeatures = Eigen::Matrix<double, region_features, 1>;

/// Returns the name of each feature, in the order of RegionFeatures.
const std::array<std::string_view, region_features>& region_feature_names();

/// Computes the features of the adjacent regions a and b:
/// - visibility, shallow and deep inside and outside (weak convexity: van Kaick et al. 2014): share of pairs of points,
///   one in each region, that see each other, and the same within each region;
/// - thickness: distances between the two distributions (earth mover's distance and means), thickness at the border
///   relative to that of the regions, thickness relative to size;
/// - border: concavity, convexity, length relative to the regions' sizes and perimeters and to the shape's girth at
///   the border; tilt of normals towards each other, over a short and a long distance;
/// - opposite sides: share of a region whose inward rays hit the same or the other region;
/// - form: elongation, flatness and spread of normals of each region and of their union; distance between their
///   centroids; areas;
/// - number of remaining regions.
RegionFeatures features_of(const Regions& regions, std::int32_t a, std::int32_t b);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>

#include "shapegauge/segmentation/regions.h"

namespace shapegauge {

inline constexpr int region_features = 44;

/// Features of two adjacent regions for deciding whether they are one part; symmetric in the two. In names, "small" and
/// "large" are the regions by area. Thickness is logarithmic; lengths and areas are relative to the whole surface.
using RegionFeatures = Eigen::Matrix<double, region_features, 1>;

/// Returns the names of the features, in order.
const std::array<std::string_view, region_features>& region_feature_names();

/// Computes the features of two regions:
/// - visibility, shallow and deep inside and outside (weak convexity: van Kaick et al. 2014): share of pairs of points,
///   one in each region, that see each other, and the same within each region;
/// - thickness: distances between the two distributions (earth mover's distance and means), the border's thickness
///   relative to the regions', thickness relative to size;
/// - border: concavity, convexity, its length relative to the regions' sizes, perimeters and the shape's girth there;
///   tilt of normals towards each other over two distances;
/// - opposite sides: share of a region that is opposite to itself or to the other;
/// - form: elongation, flatness and spread of normals of each and of both together, their distance, their sizes;
/// - number of remaining regions.
RegionFeatures features_of(const Regions& regions, std::int32_t a, std::int32_t b);

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>

#include "shapegauge/segmentation/regions.h"

namespace shapegauge {

inline constexpr int region_features = 44;

/// What tells whether two neighbouring regions are parts of one: a vector of numbers, the same for either order of the
/// two. "small" and "large" in a name are the regions by area; thickness is a logarithm, lengths and areas are in units
/// of the whole surface.
using RegionFeatures = Eigen::Matrix<double, region_features, 1>;

/// The names of the features, in order.
const std::array<std::string_view, region_features>& region_feature_names();

/// The features of two regions:
/// - lines of sight, shallow and deep inside and outside (weak convexity: van Kaick et al. 2014): the share of pairs of
///   points, one in each region, that see each other, beside that within each region;
/// - thickness: how far the two distributions are from each other (earth mover's distance and means), the border's
///   thickness against the regions', thickness against size;
/// - the border: how concave, how convex, its length against the regions' sizes, perimeters and the shape's girth
/// there;
///   the lean of normals towards each other over two distances;
/// - opposite sides: what share of a region is backed by itself or by the other;
/// - form: elongation, flatness and the spread of normals of each and of both together, their distance, their sizes;
/// - how many regions are left.
RegionFeatures features_of(const Regions& regions, std::int32_t a, std::int32_t b);

}  // namespace shapegauge

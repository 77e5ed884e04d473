// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Options of sample_points().
struct SamplePointsOptions {
  std::int64_t points = 10000;  ///< number of points
  bool with_normals = false;    ///< give each point the normal of its triangle; of a cloud, keep the normals
};

/// Names, bounds and help texts of the parameters in SamplePointsOptions (option_parameters.h).
inline constexpr std::array sample_points_table = {
    option_of<&SamplePointsOptions::points>("points", {.low = 1, .high = 100'000'000}, "Number of sampled points."),
    option_of<&SamplePointsOptions::with_normals>("with_normals", "Give the points the normals of their faces."),
};

/// Samples a mesh by a point cloud of `points` points, stratified and uniform by area. The concatenated triangle areas
/// are divided into equal parts with one point each, which spreads the points better than independent sampling.
///
/// Of a cloud, selects that many points at random in their order, or all if there are no more; with_normals then keeps
/// the cloud's normals.
///
/// Throws InputError for a number of points out of bounds, a mesh whose area is zero or not finite, and an empty shape.
Shape sample_points(const Shape& shape, const SamplePointsOptions& options, RandomNumbers& random);

/// Makes a point cloud without normals from the vertices of a mesh that a triangle uses, in their order, or from the
/// points of a cloud. Holes of the mesh become holes of the cloud.
Shape vertex_cloud(const Shape& shape);

}  // namespace shapegauge

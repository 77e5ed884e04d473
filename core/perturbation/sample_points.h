#pragma once

#include <array>
#include <cstdint>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct SamplePointsOptions {
  std::int64_t points = 10000;
  bool with_normals = false;  ///< give the points their triangles' normals
};

/// What may be chosen of SamplePointsOptions.
inline constexpr std::array sample_points_table = {
    option_of<&SamplePointsOptions::points>("points", {.low = 1, .high = 100'000'000}, "Number of points."),
    option_of<&SamplePointsOptions::with_normals>("with_normals", "Give the points the normals of their faces."),
};

/// A point cloud: so many points of the mesh, uniform by area. The area is cut, triangle after triangle, into as many
/// equal parts as there are to be points, and each part has one point: that spreads them better than independent ones.
///
/// Of a cloud, so many of its points at random, in their order, or all where it has no more; with_normals then keeps
/// the normals it has.
///
/// Throws InputError for a number of points out of bounds, a mesh whose area is zero or not finite, and an empty shape.
Shape sample_points(const Shape& shape, const SamplePointsOptions& options, RandomNumbers& random);

/// A point cloud without normals: the vertices of the mesh that a triangle uses, in their order; of a cloud, its
/// points. A hole of the mesh is one of the cloud.
Shape vertex_cloud(const Shape& shape);

}  // namespace shapegauge

#pragma once

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct SampleSurfaceOptions {
  static constexpr Bounds points_bounds{.low = 1, .high = 100'000'000};

  Eigen::Index points = 10000;
  bool with_normals = false;  ///< give the points their triangles' normals
};

/// A point cloud: so many points of the mesh, uniform by area. The area is cut, triangle after triangle, into as many
/// equal parts as there are to be points, and each part has one point: that spreads them better than independent ones.
///
/// Of a cloud, so many of its points at random, in their order, or all where it has no more; with_normals then keeps
/// the normals it has.
///
/// Throws InputError for a number of points out of bounds, a mesh whose area is zero or not finite, and an empty shape.
Shape sample_surface(const Shape& shape, const SampleSurfaceOptions& options, RandomNumbers& random);

/// A point cloud without normals: the vertices of the mesh that a triangle uses, in their order; of a cloud, its
/// points. A hole of the mesh is one of the cloud.
Shape vertex_cloud(const Shape& shape);

}  // namespace shapegauge

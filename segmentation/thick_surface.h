// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/segmentation/surface_graph.h"

namespace shapegauge {

/// Surface with outward normals and thickness at every node (triangle, or point of a cloud).
struct ThickSurface {
  SurfaceGraph graph;                  ///< adjacency of the nodes; the normals of its samples point outwards
  double unit = 1;                     ///< unit of length: square root of the surface's area, in the shape's units
  Points smooth_normals;               ///< unit normal of each node, averaged over a distance of about 0.01 `unit`
  Eigen::VectorXd log_thickness;       ///< per node: natural logarithm of the local diameter (SDF), in `unit`
  Shape barrier;                       ///< mesh that blocks rays: the surface itself, or splats() of a cloud
  int barrier_triangles_per_node = 1;  ///< number of consecutive triangles of `barrier` per node

  /// Returns the angle between the smooth normals of a node and a linked node, in radians; positive if concave.
  [[nodiscard]] double normal_angle(std::int32_t node, const SurfaceLink& link) const;
};

/// Reverses a closed mesh whose triangles face inwards; returns any other shape unchanged.
Shape orient_outward(Shape shape);

/// Computes the thickness of a shape at every triangle or point.
///
/// The thickness is the conventional SDF (cone_sdf()) if the triangles are oriented outwards. If this SDF is missing
/// for more than a quarter of the area (a cloud, an open sheet, reversed or random orientation), it is the SDF of the
/// offset surface (offset_sdf()) with the automatic_offset(), whose normals then define the outside. Missing values
/// become the mean of the neighbouring values, and all values are averaged with neighbours of similar thickness. Throws
/// InputError if the shape is unusable, is empty or has no area.
ThickSurface thick_surface(const Shape& shape);

}  // namespace shapegauge

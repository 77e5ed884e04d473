// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/segmentation/surface_graph.h"

namespace shapegauge {

/// Surface with outward normals and thickness at every node.
struct ThickSurface {
  SurfaceGraph graph;             ///< its samples' normals point outwards
  double unit = 1;                ///< square root of the area, in the shape's units
  Points smooth_normals;          ///< averaged over about a hundredth of the unit
  Eigen::VectorXd log_thickness;  ///< natural logarithm of the diameter (SDF) in units
  Shape barrier;                  ///< triangles that block rays: the mesh, or splats() of a cloud
  int barrier_triangles_per_node = 1;

  /// Returns the turn of the surface across a link, in radians, by smooth normals; positive if concave.
  [[nodiscard]] double turn(std::int32_t node, const SurfaceLink& link) const;
};

/// Reverses a closed mesh whose triangles face inwards; returns any other shape unchanged.
Shape orient_outward(Shape shape);

/// Computes the thickness of a shape at every triangle or point.
///
/// The thickness is the conventional SDF (cone_sdf()) if the triangles are oriented outwards. If that is missing for
/// more than a quarter of the area (a cloud, an open sheet, reversed or random orientation), it is the SDF of the
/// offset surface (offset_sdf()) with the automatic_offset(), whose normals then define the outside. Missing values
/// become the mean of their neighbours', and all values are averaged with neighbours of similar thickness. Throws
/// InputError if the shape is unusable, is empty or has no area.
ThickSurface thick_surface(const Shape& given);

}  // namespace shapegauge

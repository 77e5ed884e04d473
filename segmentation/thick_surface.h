#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/segmentation/surface_graph.h"

namespace shapegauge {

/// A surface that is known to have an inside: where outward is and how thick the shape is, at every node.
struct ThickSurface {
  SurfaceGraph graph;             ///< its samples' normals point outwards
  double unit = 1;                ///< square root of the area, in the shape's units
  Points smooth_normals;          ///< averaged over about a hundredth of the unit
  Eigen::VectorXd log_thickness;  ///< natural logarithm of the diameter (SDF) in units
  Shape barrier;                  ///< the triangles that rays meet: the mesh, or splats() of a cloud
  int barrier_triangles_per_node = 1;

  /// How much the surface turns over a link, in radians, by smooth normals: above 0 where it is concave.
  [[nodiscard]] double turn(std::int32_t node, const SurfaceLink& link) const;
};

/// A watertight mesh whose triangles face inward, turned inside out; any other shape as it is.
Shape facing_outward(Shape shape);

/// Finds the thickness of a shape at every triangle or point.
///
/// Where the triangles are oriented outwards, it is the conventional SDF (cone_sdf). Where that has no answer for more
/// than a quarter of the area (a cloud, an open sheet, a mesh turned inside out or oriented at random) it is that of
/// the offset surface (offset_sdf), whose normals then tell the outside, with the automatic_offset(). Nodes without a
/// value get the mean of their neighbours', and all values are averaged with neighbours of about the same thickness.
/// Throws InputError where the shape is unusable, is empty or has no area.
ThickSurface thick_surface(const Shape& given);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Values at the cell centres of a cylinder's lateral surface: rows are heights from -radius to radius, columns angles
/// from 0 to 2 pi.
using CylinderGrid = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Projection of a surface onto a cylinder, seen from outside.
struct CylinderMap {
  CylinderGrid distance;  ///< distance of the outermost surface from the axis, divided by the radius, at most 1; 0
                          ///< without surface
  CylinderGrid cosine;    ///< absolute cosine of the angle between surface normal and line of sight; 0 without surface
};

/// Geometry and resolution of a CylinderMap.
struct CylinderFrame {
  int axis = 2;       ///< coordinate axis through the origin that is the cylinder's axis: 0, 1 or 2
  double radius = 1;  ///< radius and half height of the cylinder; surface outside it is ignored
  int angles = 128;   ///< number of map columns; angle 0 is the coordinate axis after the cylinder's, in cyclic order
  int heights = 64;   ///< number of map rows, over the height of the cylinder
};

/// Projects the triangles of a mesh onto a cylinder (Papadakis, Pratikakis, Theoharis, Perantonis 2010, section 3.2). A
/// ray from the axis through each cell's centre finds the outermost triangle within the cylinder. Exact: triangles are
/// intersected with the plane of each row, and the intersections with each ray. Independent of the orientation of
/// triangles, and of their order except for normals where two triangles have the same distance. Degenerate triangles,
/// and triangles in the plane of a ray, are ignored.
CylinderMap project_on_cylinder(const Shape& mesh, const CylinderFrame& frame);

}  // namespace shapegauge

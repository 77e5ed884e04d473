#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Values by cell of a cylinder's lateral surface: a row a height, from -radius to radius, a column an angle from 0 to
/// 2 pi. The value of a cell is that at its centre.
using CylinderGrid = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A surface seen from outside a cylinder towards its axis.
struct CylinderMap {
  CylinderGrid distance;  ///< of the outermost surface from the axis, over the radius, at most 1; 0 where there is none
  CylinderGrid cosine;    ///< magnitude of the cosine of the angle between the surface's normal and the line of sight
};

/// The cells of a CylinderMap and what they cover.
struct CylinderFrame {
  int axis = 2;       ///< coordinate axis through the origin that is the cylinder's: 0, 1 or 2
  double radius = 1;  ///< of the cylinder, half its height; surface beyond it does not count
  int angles = 128;   ///< columns; the first is about the coordinate axis that follows the cylinder's
  int heights = 64;   ///< rows
};

/// Projects the triangles of a mesh on a cylinder (Papadakis, Pratikakis, Theoharis, Perantonis 2010, section 3.2):
/// from the axis a ray through the centre of each cell, and the outermost triangle that it meets within the cylinder.
/// Exact: triangles are cut with the plane of each row, and the cut with each ray. Neither the order of triangles nor
/// their orientation matters, except that one of two triangles at the same distance gives the normal. Degenerate
/// triangles, and those that lie in the plane of a ray, have no cell.
CylinderMap project_on_cylinder(const Shape& mesh, const CylinderFrame& frame);

}  // namespace shapegauge

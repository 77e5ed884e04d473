// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Ratio of an automatic offset (automatic_offset()) to the radius of the widest gap that it is meant to close.
inline constexpr double offset_per_gap = 1.1;

/// Largest automatic offset, as a fraction of the bounding-box diagonal: a larger offset surface says little about the
/// shape.
inline constexpr double largest_automatic_offset = 0.05;

/// Radii of gaps, in the shape's units.
struct GapSizes {
  double widest = 0;    ///< radius of the widest gap of the shape; 0 without gaps
  double closable = 0;  ///< radius of the widest gap that the largest automatic offset closes
};

/// Computes the radii of the gaps of a shape: the largest offset with which the outside reaches an inner space through
/// a gap. 0 for a closed mesh.
///
/// An inner space is deeper than its gap is wide, by a factor of 1.3. The mouth of a cup, the border of a sheet and the
/// outline of a patch next to others are therefore no gaps, whatever their size. For a cloud both radii are at least
/// the distance within which 99.9 % of the points have their sixth neighbour (or their last, in smaller clouds): balls
/// of that radius about random points leave hardly a hole.
///
/// Determined on a grid of about 200,000 distances to the shape, whose cells have at most about 1 % of the diagonal.
/// Radii are accurate to about half a cell. If an inner space is open only through gaps below half a cell, the radius
/// is half the width of the widest crack of the mesh. Independent of orientation and of the order of vertices and
/// triangles. Throws InputError for an unusable shape (require_usable()).
GapSizes gap_sizes(const Shape& shape);

/// Computes the point spacing of a cloud: the median distance to the sixth neighbour. On a regular surface it is about
/// 1.4 times the mean distance. 0 for a mesh. Throws InputError for an unusable shape (require_usable()).
double point_spacing(const Shape& shape);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/fields/inscribed_ball.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Limits of check_part(). Lengths and areas are in the shape's units.
struct CheckOptions {
  double min_wall = 0;  ///< minimum thickness of walls; 0: not checked
  double min_gap = 0;   ///< minimum width of gaps; 0: not checked
  /// Minimum area of the regions to list; smaller regions are only counted. It is raised to the square of an eighth of
  /// the limit (min_wall or min_gap), or to a hundredth of the surface if that is less, for very small parts.
  double min_area = 0;
  bool keep_surface = false;       ///< true to fill PartReport::surface
  InscribedBallOptions ball = {};  ///< options of the balls whose diameters are the thickness and width
};

/// Connected region of the surface whose thickness, or distance across a gap, is below the limit.
struct ThinRegion {
  double area = 0;     ///< area of the region, in the shape's units squared
  double minimum = 0;  ///< smallest wall thickness or gap width in the region, in the shape's units
  double median = 0;   ///< median wall thickness or gap width in the region, weighted by area, in the shape's units
  /// Point of the region where the thickness or width is `minimum`.
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  /// Point of the surface opposite to `position`, which the ball of the diameter `minimum` touches too.
  Eigen::Vector3d opposite = Eigen::Vector3d::Zero();
  /// True for a sharp edge or notch whose sides diverge by more than 30 degrees until their distance reaches the limit
  /// of thin walls or gaps. It is listed, but is no violation. A thin region that never reaches the limit is a wall,
  /// whatever its cross-section.
  bool is_edge = false;
  std::vector<std::int32_t> faces;  ///< indices of the faces that the region covers at least partly, ascending
};

/// Thin regions of a surface below one limit, that of wall thickness or that of gap width.
struct ThinRegions {
  double limit = 0;  ///< minimum thickness or width that was checked, in the shape's units; 0: not checked
  std::vector<ThinRegion>
      regions;                    ///< regions of at least the minimum area: violations, then edges, each largest first
  std::size_t small_regions = 0;  ///< number of regions that are not listed because they are below the minimum area
  double small_area = 0;          ///< total area of the regions that are not listed, in the shape's units squared
  /// Maximum spacing of the samples, in the shape's units: the limit, or more on a mesh of a very large area. Thin
  /// regions narrower than this may be missed.
  double spacing = 0;

  /// Returns true if no region is a violation: all are sharp edges or notches (ThinRegion::is_edge).
  [[nodiscard]] bool pass() const;
};

/// Surface of a part as a mesh whose triangles are divided where thickness or gap width is below a limit.
struct CheckedSurface {
  Shape mesh;                 ///< divided surface, in the shape's coordinates
  Eigen::VectorXd fractions;  ///< per triangle: smallest thickness or width / limit; NaN where the limits are met
};

/// Result of check_part().
struct PartReport {
  ThinRegions walls;      ///< regions whose thickness is below CheckOptions::min_wall
  ThinRegions gaps;       ///< regions whose distance across a gap is below CheckOptions::min_gap
  std::size_t voids = 0;  ///< number of closed cavities inside the part (closed_components())
  bool closed = false;    ///< true if closed and consistently oriented; if not, normals are assumed to point outwards
  CheckedSurface surface = {};  ///< surface divided along thin regions; empty unless CheckOptions::keep_surface

  [[nodiscard]] bool passes() const { return walls.pass() && gaps.pass(); }  ///< true without violations
};

/// Finds the regions of a mesh whose walls are too thin or whose gaps are too narrow (docs/manual/check.md).
///
/// The thickness at a point of the surface is the diameter of its inscribed_ball(); the width of a gap is the diameter
/// of the ball on the outside. Faces are divided until the pieces are smaller than the limit or have no opposite
/// surface nearby, and further along the border of a region. Closed meshes may face inwards as a whole. The result is
/// the same on any number of threads.
///
/// Throws InputError for a cloud, an unusable shape, a mesh without area, and for limits that are negative or all 0.
PartReport check_part(const Shape& mesh, const CheckOptions& options);

}  // namespace shapegauge

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
  /// Smaller regions are only counted. At least the square of an eighth of the limit, but no more than a hundredth of
  /// the surface: a part much smaller than the limit is a thin wall.
  double min_area = 0;
  bool keep_surface = false;  ///< fill PartReport::surface
  InscribedBallOptions ball = {};
};

/// Connected region of the surface whose thickness, or distance across a gap, is below the limit.
struct ThinRegion {
  double area = 0;
  double minimum = 0;                                  ///< diameter of the smallest ball
  double median = 0;                                   ///< of the diameters, by area
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the smallest ball: where it touches the region
  Eigen::Vector3d opposite = Eigen::Vector3d::Zero();  ///< and the opposite surface
  /// The sides of a sharp edge, or of a notch, which are listed, but no violation: they open by more than 30 degrees up
  /// to the limit. A thin place that never reaches the limit is a wall, whatever its section.
  bool is_edge = false;
  std::vector<std::int32_t> faces;  ///< faces that the region covers at least partly, ascending
};

/// Regions below one limit.
struct ThinRegions {
  double limit = 0;
  std::vector<ThinRegion> regions;  ///< by area, largest first
  std::size_t small_regions = 0;    ///< smaller than CheckOptions::min_area
  double small_area = 0;            ///< of all of these
  /// Spacing of samples on faces opposite to a wall or gap. Narrower thin places may be missed.
  double spacing = 0;

  [[nodiscard]] bool pass() const;
};

/// Surface of a part, divided where it is below a limit: the triangles of a mesh with the smallest diameter in each, as
/// a fraction of the limit for walls or gaps. NaN where the part passes.
struct CheckedSurface {
  Shape mesh;
  Eigen::VectorXd fractions;
};

/// Result of check_part().
struct PartReport {
  ThinRegions walls;
  ThinRegions gaps;
  std::size_t voids = 0;        ///< closed cavities (closed_components())
  bool closed = false;          ///< closed and consistently oriented; otherwise the orientation of each face decides
  CheckedSurface surface = {};  ///< empty unless CheckOptions::keep_surface

  [[nodiscard]] bool passes() const { return walls.pass() && gaps.pass(); }
};

/// Finds the regions of a mesh whose walls are too thin or whose gaps are too narrow (docs/manual/check.md).
///
/// The thickness at a point of the surface is the diameter of its inscribed_ball(), the width of a gap that of the ball
/// outside. Faces are divided until their parts are smaller than the limit, or lie opposite to nothing, and
/// along the border of a region further. Closed meshes may face inwards as a whole. The same result on any number of
/// threads.
///
/// Throws InputError for a cloud, an unusable shape, a mesh without area, and for limits that are negative or all 0.
PartReport check_part(const Shape& mesh, const CheckOptions& options);

}  // namespace shapegauge

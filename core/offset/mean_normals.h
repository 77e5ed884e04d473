// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: p sample, n its normal, p' raised sample, q closest point of E(r) to p', r offset distance.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "shapegauge/core/offset/grid_surface.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Depth of p + r n inside the offset solid O(r), in units of r, from which on a sample p is raised along the mean of
/// the surrounding normals. At smaller depths the sample's normal n is mixed in, which makes values continuous where q
/// = p + r n becomes covered.
inline constexpr double blend_depth = 0.05;

/// Returns p', the sample p moved off the surface by the offset distance r, in a direction between its normal and the
/// mean of the surrounding normals. The search for q starts from p'. `depth` is the depth of p + r n inside the offset
/// solid O(r), in units of r.
inline Eigen::Vector3d raised(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, const Eigen::Vector3d& mean,
                              double depth, double r) {
  const double part = std::min(1.0, depth / blend_depth);
  return p + r * ((1 - part) * normal + part * mean);
}

/// Local means of a surface's normals, in whose direction samples are moved off the surface
/// (docs/methods/offset_sdf.md#why-the-sample-is-raised).
class MeanNormals {
 public:
  MeanNormals(const BlockGrid& grid, const Shape& shape, const GridSurface& surface, bool parallel);

  /// Returns M M n, where M is the mean of n_j n_j^T over the normals n_j of the surface within r/2 of the sample p (in
  /// cells), weighted by proximity. n is the normal of p, and r the offset distance. Its length is 1 on a flat surface
  /// and less where normals differ. The orientation of the n_j has no effect. Returns n if there are no triangles.
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& p, const Eigen::Vector3d& n) const;

 private:
  const BlockGrid& grid_;  ///< grid of `surface_`
  const GridSurface& surface_;
  /// Per point of the surface: components of the unit normal of its triangle, 0 if undefined. Padded; empty without
  /// triangles.
  AlignedArray<float> x_, y_, z_;
};

}  // namespace shapegauge

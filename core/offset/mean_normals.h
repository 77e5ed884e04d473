#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/core/offset/grid_surface.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// How far a sample is raised where the surface is flat, in parts of r: ties and flat minima of |pq| are decided by the
/// normals around it.
inline constexpr double raised_by = 0.4;

/// Means of a surface's normals over places, by which samples are raised (docs/offset_sdf.md#why-the-sample-is-raised).
class MeanNormals {
 public:
  MeanNormals(const BlockGrid& grid, const Shape& shape, const GridSurface& surface);

  /// The mean of (n_j . n) n_j over the surface within r/2 of p (in cells), n_j being its normals; what is nearer
  /// weighs more. Its length is 1 where the surface is flat, and less where normals differ. On which sides the n_j
  /// point does not matter. Without triangles it is n.
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& p, const Eigen::Vector3d& n) const;

 private:
  const BlockGrid& grid_;
  const GridSurface& surface_;
  /// Of each of the surface's points its triangle's normal, of length 1 or 0. Padded; empty without triangles.
  std::vector<float> x_, y_, z_;
};

}  // namespace shapegauge

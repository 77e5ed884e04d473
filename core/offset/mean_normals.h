#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "shapegauge/core/offset/grid_surface.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Up to so deep inside of O(r), in parts of r, the direction in which a sample is raised turns from its normal to the
/// mean of those around it: values change steadily where q = p + r n gets covered.
inline constexpr double shallow = 0.05;

/// p': the place on one side of a sample p, the normal's and the mean's, from which E(r) is closest to it at q. Depth
/// is how far p + r n is inside of O(r), in parts of r.
inline Eigen::Vector3d raised(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, const Eigen::Vector3d& mean,
                              double depth, double r) {
  const double part = std::min(1.0, depth / shallow);
  return p + r * ((1 - part) * normal + part * mean);
}

/// Means of a surface's normals over places, by which samples are raised
/// (docs/methods/offset_sdf.md#why-the-sample-is-raised).
class MeanNormals {
 public:
  MeanNormals(const BlockGrid& grid, const Shape& shape, const GridSurface& surface);

  /// m = M M n, where M is the mean of n_j n_j^T over the surface within r/2 of p (in cells), n_j being its normals;
  /// what is nearer weighs more. Its length is 1 where the surface is flat, and less where normals differ. On which
  /// sides the n_j point does not matter. Without triangles it is n.
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& p, const Eigen::Vector3d& n) const;

 private:
  const BlockGrid& grid_;
  const GridSurface& surface_;
  /// Of each of the surface's points its triangle's normal, of length 1 or 0. Padded; empty without triangles.
  std::vector<float> x_, y_, z_;
};

}  // namespace shapegauge

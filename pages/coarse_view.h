// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/pages/shape_view.h"

namespace shapegauge {

/// Cache version of coarse_shape() and ValueTransfer; increment when results change (docs/manual/cache.md).
inline constexpr int coarse_shape_version = 2;

/// Simplifies a shape for display to at most `faces` >= 100 faces, however broken the mesh is. Uses decimate().
/// For meshes with many more faces, and where edge collapses stop early, first merges the vertices in each cell of a
/// grid to their mean (Rossignac and Borrel 1993). Of a point cloud, selects `faces` points. Returns a shape that is
/// already small enough unchanged.
Shape coarse_shape(const Shape& shape, Eigen::Index faces);

/// Transfers values from samples of a shape (sources) to samples of a coarser shape (targets). A target gets the mean
/// of all sources to which it is the nearest target or, without any, the value of its nearest source. The nearest
/// sample is the first of the four nearest whose normal is not opposite, which separates the sides of thin sheets.
class ValueTransfer {
 public:
  ValueTransfer(const Samples& from, const Samples& to);  ///< matches the sources `from` with the targets `to`

  /// Returns the area-weighted mean of the source values for each target, ignoring NaN.
  [[nodiscard]] Eigen::VectorXd means(const Eigen::VectorXd& values) const;
  /// Returns the normalised mean of the sources' unit vectors for each target; zero vectors stay zero.
  [[nodiscard]] Points directions(const Points& directions) const;
  /// Returns the source label with the largest area for each target (ties: the smallest label).
  [[nodiscard]] std::vector<std::int32_t> labels(const std::vector<std::int32_t>& labels) const;

 private:
  Eigen::VectorXd weights_;               ///< area weight of each source
  std::vector<std::int32_t> target_of_;   ///< index of the nearest target of each source
  std::vector<std::int32_t> nearest_to_;  ///< index of the nearest source of each target
};

/// Simplifies the shape of a view by coarse_shape() and transfers the view's fields, parts and normals to it. `samples`
/// are the samples of view.shape at view.site, `faces` is the maximum number of faces.
ShapeView coarse_view(ShapeView view, const Samples& samples, Eigen::Index faces);

}  // namespace shapegauge

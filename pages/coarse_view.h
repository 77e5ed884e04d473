// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/pages/shape_view.h"

namespace shapegauge {

/// Cache version of coarse_shape() and CarriedValues; see docs/manual/cache.md.
inline constexpr int coarse_shape_version = 2;

/// Simplifies a shape for display to at most `faces` faces, at least 100, however broken the mesh is. Uses decimate().
/// For meshes with many more faces, and where edge collapses stop early, first merges the vertices in each cell of a
/// grid to their mean (Rossignac and Borrel 1993). Of a cloud, selects that many points. Returns a shape that is small
/// enough unchanged.
Shape coarse_shape(const Shape& shape, Eigen::Index faces);

/// Transfers values at samples of a shape to samples of a coarser one. Each target takes the mean of the sources that
/// are nearest to it, or the value of its own nearest source if there are none. Among the four nearest, the first whose
/// normal does not point the opposite way is used, which separates the two sides of a thin sheet.
class CarriedValues {
 public:
  CarriedValues(const Samples& from, const Samples& to);

  /// Returns means weighted by area, ignoring NaN values.
  [[nodiscard]] Eigen::VectorXd means(const Eigen::VectorXd& values) const;
  /// Returns means of unit vectors, normalised or zero.
  [[nodiscard]] Points directions(const Points& directions) const;
  /// Returns the label with the largest area (ties: the smallest).
  [[nodiscard]] std::vector<std::int32_t> labels(const std::vector<std::int32_t>& labels) const;

 private:
  Eigen::VectorXd weights_;               ///< of the sources
  std::vector<std::int32_t> target_of_;   ///< by source
  std::vector<std::int32_t> nearest_to_;  ///< by target
};

/// Returns the view of the coarse_shape(). `samples` are those of the view's shape, at its site.
ShapeView coarse_view(ShapeView view, const Samples& samples, Eigen::Index faces);

}  // namespace shapegauge

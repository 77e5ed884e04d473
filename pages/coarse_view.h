#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/pages/shape_view.h"

namespace shapegauge {

/// To be raised with every change of coarse_shape() and CarriedValues: what a cache holds of earlier versions is then
/// made anew.
inline constexpr int coarse_shape_version = 2;

/// A mesh that looks like the given one and has at most so many faces, at least 100, however broken the mesh is: by
/// decimate(); of a mesh with many more faces, and where edge collapses do not get that far, after the vertices in each
/// cell of a grid were made one, their mean (Rossignac and Borrel 1993). Of a cloud, so many of its points. A shape
/// that is small enough is returned as it is.
Shape coarse_shape(const Shape& shape, Eigen::Index faces);

/// Carries what is known at places of a shape over to the places of a coarser one: each of these takes the mean of
/// those to which it is nearest, and one that is nearest to none takes what its own nearest place has. Of the four
/// nearest the first counts whose normal does not point the other way, so that the two sides of a thin sheet stay
/// apart.
class CarriedValues {
 public:
  CarriedValues(const Samples& from, const Samples& to);

  /// Means weighted by the area; values that are NaN are left out.
  [[nodiscard]] Eigen::VectorXd means(const Eigen::VectorXd& values) const;
  /// Means of unit vectors, of unit length again or zero.
  [[nodiscard]] Points directions(const Points& directions) const;
  /// The label of the largest area; of several, the smallest one.
  [[nodiscard]] std::vector<std::int32_t> labels(const std::vector<std::int32_t>& labels) const;

 private:
  Eigen::VectorXd weights_;               ///< of the places carried from
  std::vector<std::int32_t> target_of_;   ///< by place carried from
  std::vector<std::int32_t> nearest_to_;  ///< by place carried to
};

/// The view of the coarse_shape().
ShapeView coarse_view(ShapeView view, Eigen::Index faces);

}  // namespace shapegauge

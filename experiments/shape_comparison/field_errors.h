// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

/// Cache version; increment when errors change.
inline constexpr int field_errors_version = 1;

/// Returns the weighted quantile: the smallest value whose cumulative weight reaches this fraction of the total. With
/// 0.5 it is the (lower) median, always one of the values. NaN without values or weight. Throws ArgumentError for
/// different numbers of values and weights.
double weighted_quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, double fraction);

/// Ground-truth normals: those of a mesh's triangles.
class TrueNormals {
 public:
  /// Throws ArgumentError for a point cloud.
  explicit TrueNormals(const Shape& mesh);

  /// Returns the unit normal, by the order of corners, of the triangle nearest to the point; zero for a triangle
  /// without area.
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& point) const;

 private:
  UnitFrame frame_;
  TriangleBVH tree_;
};

/// Angles between normals and the ground truth, in degrees, weighted by the area of samples.
struct NormalErrors {
  double mean = 0;
  double median = 0;
  double percentile_90 = 0;
};

/// Computes the errors of unit normals at points. Ignores zero normals and zero weights; all NaN if nothing is left.
/// With `sided`, an opposite normal is wrong by 180 degrees; otherwise it is correct. Runs in the calling TBB arena.
NormalErrors normal_errors(const TrueNormals& truth, const Points& points, const Points& normals,
                           const Eigen::VectorXd& weights, bool sided);

/// Values of a field with their positions, in the units of the shape's file.
struct PlacedValues {
  Points points;
  Eigen::VectorXd values;  ///< all finite
  FieldDimension dimension = FieldDimension::length;
};

/// Selects the samples with a value and a positive area and converts them to units of the shape's file: lengths are
/// multiplied by `unit`, and values by unit_of(dimension, unit).
PlacedValues placed_values(const Samples& samples, const Eigen::VectorXd& values, FieldDimension dimension,
                           double unit);

/// Errors of a field relative to a reference: quantiles over samples of |value - reference's value at its nearest
/// sample|, unweighted.
struct ValueErrors {
  double median = 0;                  ///< lengths as fractions of the reference's diagonal, areas of its square
  double percentile_90 = 0;           ///< in the same units
  double relative_median = 0;         ///< of the errors divided by the magnitude of the reference's value
  double relative_percentile_90 = 0;  ///< of the same relative errors
};

/// Computes the errors of values relative to the reference's, which must have the same units, position and dimension.
/// NaN if either has no values. Runs in the calling TBB arena.
ValueErrors value_errors(const PlacedValues& placed, const PlacedValues& reference, double reference_diagonal);

}  // namespace shapegauge

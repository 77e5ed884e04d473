// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

/// Cache version of the errors of fields and normals; increment when they change.
inline constexpr int field_errors_version = 1;

/// Returns the weighted quantile of values: the smallest value whose cumulative weight reaches this fraction of the
/// total. With 0.5 it is the (lower) median, always one of the values. NaN without values or weight. Throws
/// ArgumentError for different numbers of values and weights.
double weighted_quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, double fraction);

/// Ground-truth normals of a surface: the triangle normals of its mesh.
class TrueNormals {
 public:
  /// Builds a search tree over the triangles of the mesh. Throws ArgumentError for a point cloud.
  explicit TrueNormals(const Shape& mesh);

  /// Returns the unit normal of the triangle nearest to the point, oriented by the order of its corners; zero for a
  /// triangle without area.
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& point) const;

 private:
  UnitFrame frame_;   ///< transformation of points to the coordinates of the search tree
  TriangleBVH tree_;  ///< search tree over the triangles
};

/// Area-weighted statistics of the angles between normals and ground-truth normals, in degrees.
struct NormalErrors {
  double mean = 0;           ///< mean angle in degrees
  double median = 0;         ///< median angle in degrees
  double percentile_90 = 0;  ///< 90th percentile of the angles in degrees
};

/// Computes the errors of unit normals at points (one per row). Ignores zero normals and zero weights; all errors are
/// NaN if no normal is left. With `sided`, an opposite normal has an error of 180 degrees; otherwise of 0. Runs in
/// the calling TBB arena.
NormalErrors normal_errors(const TrueNormals& truth, const Points& points, const Points& normals,
                           const Eigen::VectorXd& weights, bool sided);

/// Values of a field with the positions of their samples, in the units of the shape's file.
struct LocatedValues {
  Points points;                                      ///< positions of the samples, one per row
  Eigen::VectorXd values;                             ///< values of the field, one per point, all finite
  FieldDimension dimension = FieldDimension::length;  ///< dimension of the values, such as length or area
};

/// Selects the samples with a finite value and a positive area and converts them to the units of the shape's file:
/// positions are multiplied by `unit`, and values by unit_of(dimension, unit).
LocatedValues located_values(const Samples& samples, const Eigen::VectorXd& values, FieldDimension dimension,
                             double unit);

/// Errors of a field relative to a reference: unweighted quantiles over samples of |value - reference value|. The
/// reference value is the value at the nearest sample of the reference.
struct ValueErrors {
  double median = 0;                  ///< median error: of lengths / reference diagonal, of areas / squared diagonal
  double percentile_90 = 0;           ///< 90th percentile of the errors, in the units of `median`
  double relative_median = 0;         ///< median of |value - reference value| / |reference value|
  double relative_percentile_90 = 0;  ///< 90th percentile of |value - reference value| / |reference value|
};

/// Computes the errors of field values relative to a reference, which must have the same units, position and dimension.
/// `reference_diagonal` is the diagonal of the reference's bounding box. NaN if the field or the reference has no
/// values. Runs in the calling TBB arena.
ValueErrors value_errors(const LocatedValues& field, const LocatedValues& reference, double reference_diagonal);

}  // namespace shapegauge

#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "shapegauge/core/fields/field.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

/// Weighted quantile: the smallest value such that the values up to it carry at least this fraction of the total
/// weight. With 0.5 it is the (lower) median, always one of the values. NaN where there are no values or no weight.
/// Throws ArgumentError where values and weights differ in number.
double weighted_quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, double fraction);

/// Ground-truth normals: those of a mesh's triangles.
class TrueNormals {
 public:
  /// Throws ArgumentError for a point cloud.
  explicit TrueNormals(const Shape& mesh);

  /// The unit normal, by its corners' order, of the triangle nearest to the point; zero where that has no area.
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& point) const;

 private:
  UnitFrame frame_;
  TriangleBVH tree_;
};

/// Angles between normals and the truth, in degrees, each weighted by the area of its sample.
struct NormalErrors {
  double mean = 0;
  double median = 0;
  double percentile_90 = 0;
};

/// The errors of the unit normals at the points. Zero normals do not count, nor do weights of zero; all is NaN where
/// nothing counts. sided: whether a normal that points the other way is wrong by 180 degrees; otherwise it is right.
/// Runs in the calling TBB arena.
NormalErrors normal_errors(const TrueNormals& truth, const Points& points, const Points& normals,
                           const Eigen::VectorXd& weights, bool sided);

/// Values of a field where they are, in the units of the shape's file.
struct PlacedValues {
  Points points;
  Eigen::VectorXd values;  ///< all of them finite
  FieldDimension dimension = FieldDimension::length;
};

/// The values at samples that have one and that stand for some area, in units of the shape's file: lengths are
/// multiplied by `unit`, and values by unit_of(dimension, unit).
PlacedValues placed_values(const Samples& samples, const Eigen::VectorXd& values, FieldDimension dimension,
                           double unit);

/// How far a field is from that of the reference: quantiles of |value - reference's value at its sample nearest by|,
/// each sample counting once.
struct ValueErrors {
  double median = 0;                  ///< of lengths as fractions of the reference's diagonal, of areas as fractions of
                                      ///< its square, of values without a dimension unscaled
  double percentile_90 = 0;           ///< as above
  double relative_median = 0;         ///< of the errors, each divided by the magnitude of the reference's value
  double relative_percentile_90 = 0;  ///< of those
};

/// The errors of the values with respect to the reference's, which are in the same units and place and of the same
/// dimension. NaN where either has no values. Runs in the calling TBB arena.
ValueErrors value_errors(const PlacedValues& placed, const PlacedValues& reference, double reference_diagonal);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/shape_comparison/field_errors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"

namespace shapegauge {

double weighted_quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, double fraction) {
  if (values.size() != weights.size()) {
    throw ArgumentError("there are " + std::to_string(weights.size()) + " weights for " +
                        std::to_string(values.size()) + " values");
  }
  const double total = weights.sum();
  if (!(total > 0)) return std::numeric_limits<double>::quiet_NaN();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::stable_sort(order, {}, [&](Eigen::Index i) { return values[i]; });
  double below = 0;
  for (const Eigen::Index i : order) {
    below += weights[i];
    if (weights[i] > 0 && below >= fraction * total) return values[i];
  }
  return values[order.back()];  // rounding made the sum less than the total
}

namespace {

double degrees_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b, bool sided) {
  const double cosine = a.dot(b);
  return std::atan2(a.cross(b).norm(), sided ? cosine : std::abs(cosine)) * 180 / std::numbers::pi;
}

const Shape& required_mesh(const Shape& shape) {
  if (is_cloud(shape)) throw ArgumentError("ground-truth normals need triangles, and the shape is a point cloud");
  return shape;
}

/// Returns the value of the reference nearest to each point.
Eigen::VectorXd nearest_values(const Points& points, const LocatedValues& reference) {
  const Shape sites{.vertices = reference.points, .triangles = {}};
  const UnitFrame frame = unit_frame(sites);
  const TriangleBVH tree(in_unit_frame(sites, frame));
  Eigen::VectorXd nearest(points.rows());
  parallel_for(Eigen::Index{0}, points.rows(), [&](Eigen::Index i) {
    const auto hit = tree.closest(frame.to_unit(points.row(i).transpose()));
    nearest[i] = reference.values[hit.value().triangle];
  });
  return nearest;
}

}  // namespace

TrueNormals::TrueNormals(const Shape& mesh)
    : frame_(unit_frame(required_mesh(mesh))), tree_(in_unit_frame(mesh, frame_)) {}

Eigen::Vector3d TrueNormals::at(const Eigen::Vector3d& point) const {
  const Triangle triangle = tree_.triangle(tree_.closest(frame_.to_unit(point)).value().triangle);
  return (triangle.b - triangle.a).cross(triangle.c - triangle.a).stableNormalized();
}

NormalErrors normal_errors(const TrueNormals& truth, const Points& points, const Points& normals,
                           const Eigen::VectorXd& weights, bool sided) {
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(points.rows());
  Eigen::VectorXd counted = weights;
  parallel_for(Eigen::Index{0}, points.rows(), [&](Eigen::Index i) {
    const Eigen::Vector3d expected = truth.at(points.row(i));
    const Eigen::Vector3d normal = normals.row(i);
    // NaN also means a missing normal.
    if (expected.squaredNorm() > 0 && normal.squaredNorm() > 0) {
      angles[i] = degrees_between(normal, expected, sided);
    } else {
      counted[i] = 0;
    }
  });
  const double total = counted.sum();
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {.mean = total > 0 ? angles.dot(counted) / total : none,
          .median = weighted_quantile(angles, counted, 0.5),
          .percentile_90 = weighted_quantile(angles, counted, 0.9)};
}

LocatedValues located_values(const Samples& samples, const Eigen::VectorXd& values, FieldDimension dimension,
                             double unit) {
  std::vector<Eigen::Index> valid;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) && samples.weights[i] > 0) valid.push_back(i);
  }
  return {.points = samples.points(valid, Eigen::all) * unit,
          .values = values(valid) * unit_of(dimension, unit),
          .dimension = dimension};
}

ValueErrors value_errors(const LocatedValues& field, const LocatedValues& reference, double reference_diagonal) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (field.values.size() == 0 || reference.values.size() == 0) return {none, none, none, none};
  const Eigen::VectorXd expected = nearest_values(field.points, reference);
  const Eigen::VectorXd errors = (field.values - expected).cwiseAbs();
  // Without an error, a value of 0 has no relative error either.
  const Eigen::VectorXd relative =
      errors.binaryExpr(expected, [](double error, double value) { return error == 0 ? 0 : error / std::abs(value); });
  const Eigen::VectorXd once = Eigen::VectorXd::Ones(errors.size());
  const double unit = unit_of(reference.dimension, reference_diagonal);
  return {.median = weighted_quantile(errors, once, 0.5) / unit,
          .percentile_90 = weighted_quantile(errors, once, 0.9) / unit,
          .relative_median = weighted_quantile(relative, once, 0.5),
          .relative_percentile_90 = weighted_quantile(relative, once, 0.9)};
}

}  // namespace shapegauge

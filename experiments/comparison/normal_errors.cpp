#include "shapegauge/experiments/comparison/normal_errors.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <tbb/parallel_for.h>
#include <vector>

#include "shapegauge/experiments/comparison/weighted_quantile.h"

namespace shapegauge {

namespace {

double degrees_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b, bool sided) {
  const double cosine = a.dot(b);
  return std::atan2(a.cross(b).norm(), sided ? cosine : std::abs(cosine)) * 180 / std::numbers::pi;
}

const Shape& required_mesh(const Shape& shape) {
  if (is_cloud(shape)) throw std::invalid_argument("a point cloud has no triangles to take true normals from");
  return shape;
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
  tbb::parallel_for(Eigen::Index{0}, points.rows(), [&](Eigen::Index i) {
    const Eigen::Vector3d expected = truth.at(points.row(i));
    const Eigen::Vector3d normal = normals.row(i);
    // NaN, too, is a normal that is not there.
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

}  // namespace shapegauge

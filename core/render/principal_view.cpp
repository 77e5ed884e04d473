#include "shapegauge/core/render/principal_view.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace shapegauge {

namespace {

/// Below this skewness (third moment by the cube of the standard deviation) an axis counts as balanced: rounding must
/// not decide the view.
constexpr double balanced_skewness = 1e-3;

/// Calls visit(point, weight) for points with the moments of the surface up to the second: the triangles' corners and
/// centroids, a rule that is exact for polynomials of degree 2. Of a cloud, for its points.
template <typename Visit>
void visit_weighted_points(const Shape& shape, const Visit& visit) {
  for (Eigen::Index i = 0; i < shape.triangles.rows(); ++i) {
    const Eigen::Vector3d a = shape.vertices.row(shape.triangles(i, 0));
    const Eigen::Vector3d b = shape.vertices.row(shape.triangles(i, 1));
    const Eigen::Vector3d c = shape.vertices.row(shape.triangles(i, 2));
    const double area = (b - a).cross(c - a).norm() / 2;
    for (const auto& corner : {a, b, c}) visit(corner, area / 12);
    visit((a + b + c) / 3, area * 3 / 4);
  }
  if (!is_cloud(shape)) return;
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) visit(shape.vertices.row(i).transpose(), 1);
}

/// The axis or its opposite.
Eigen::Vector3d pointed(const Eigen::Vector3d& axis, double variance, double third_moment) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  const bool balanced = std::abs(third_moment) <= balanced_skewness * std::pow(variance, 1.5);
  return (balanced ? axis[largest] : third_moment) < 0 ? Eigen::Vector3d(-axis) : axis;
}

}  // namespace

RenderOptions principal_view(const Shape& shape, RenderOptions options) {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  visit_weighted_points(shape, [&](const Eigen::Vector3d& point, double weight) {
    mass += weight;
    centre += weight * point;
  });
  if (!(mass > 0) || !std::isfinite(mass) || !centre.allFinite()) return options;
  centre /= mass;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  visit_weighted_points(shape, [&](const Eigen::Vector3d& point, double weight) {
    const Eigen::Vector3d arm = point - centre;
    second += (weight / mass * arm) * arm.transpose();
  });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(second);  // ascending
  const Eigen::Matrix3d to_axes = principal.eigenvectors().transpose();
  Eigen::Vector3d third = Eigen::Vector3d::Zero();
  visit_weighted_points(shape, [&](const Eigen::Vector3d& point, double weight) {
    const Eigen::Array3d along = to_axes * (point - centre);
    third += (weight / mass * along * along * along).matrix();
  });
  Eigen::Matrix3d axes;
  for (int k = 0; k < 3; ++k)
    axes.col(k) = pointed(principal.eigenvectors().col(k), principal.eigenvalues()[k], third[k]);
  options.up = axes.col(1);
  options.towards_viewer = axes.col(0) + 0.35 * axes.col(2) + 0.45 * axes.col(1);
  return options;
}

}  // namespace shapegauge

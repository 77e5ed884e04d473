// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

Samples some_samples(const Shape& shape) { return sample_surface(shape, 60); }

/// The definition of interpolate_to_samples() implemented literally: of the seven nearest points, by distance and
/// normals.
double interpolated(const SurfaceProxy& proxy, const Eigen::RowVector3d& position, const Eigen::RowVector3d& normal,
                    const Eigen::VectorXd& values) {
  std::vector<std::pair<double, Eigen::Index>> nearest;
  for (Eigen::Index i = 0; i < proxy.points.rows(); ++i)
    nearest.emplace_back((proxy.points.row(i) - position).norm(), i);
  std::ranges::sort(nearest);
  nearest.resize(7);
  double sum = 0;
  double weights = 0;
  for (const auto& [distance, i] : nearest) {
    const double weight =
        std::pow(1 - distance / nearest.back().first, 2) * std::pow(proxy.normals.row(i).dot(normal), 2);
    sum += weight * values[i];
    weights += weight;
  }
  return sum / weights;
}

TEST(ProxySource, InterpolationWeightsFollowDistanceAndNormals) {
  const Shape torus = test::torus(1, 0.4, 30, 16);
  ProxySource source(torus);
  const SurfaceProxy& proxy = source.proxy();
  const Samples samples = some_samples(torus);
  const Eigen::VectorXd values = proxy.points.col(0).array().sin() + 2 * proxy.points.col(2).array();
  const Eigen::VectorXd found = source.interpolate_to_samples(samples, values);
  ASSERT_EQ(found.size(), samples.points.rows());
  for (Eigen::Index i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], interpolated(proxy, samples.points.row(i), samples.normals.row(i), values), 1e-4) << i;
  }
}

TEST(ProxySource, InterpolationPreservesConstantsAndStepsAtSharpEdges) {
  const Shape box = test::box({3, 2, 1}, 6);
  ProxySource source(box);
  const Eigen::Index count = source.proxy().points.rows();
  const Samples samples = some_samples(box);
  EXPECT_LT(
      (source.interpolate_to_samples(samples, Eigen::VectorXd::Constant(count, 7.5)).array() - 7.5).abs().maxCoeff(),
      1e-12);
  // A step between two sides: next to their edge the points of the other side hardly count.
  Eigen::VectorXd step(count);
  for (Eigen::Index i = 0; i < count; ++i) step[i] = std::abs(source.proxy().normals(i, 2)) > 0.9 ? 1 : 0;
  const Eigen::VectorXd found = source.interpolate_to_samples(samples, step);
  for (Eigen::Index i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], std::abs(samples.normals(i, 2)), 0.01) << samples.points.row(i);
  }
}

TEST(ProxySource, InterpolationGivesTheNearestProxyPointTheLargestWeight) {
  const Shape sphere = test::sphere(1, 4);
  ProxySource source(sphere);
  const SurfaceProxy& proxy = source.proxy();
  Samples at_points;
  at_points.points = proxy.points.topRows(50);
  at_points.normals = proxy.normals.topRows(50);
  for (Eigen::Index i = 0; i < 50; ++i) {
    const Eigen::VectorXd found =
        source.interpolate_to_samples(at_points, Eigen::VectorXd::Unit(proxy.points.rows(), i));
    EXPECT_GT(found[i], 0.5);
    EXPECT_LE(found[i], 1);
  }
}

TEST(ProxySource, SpectrumDoesNotDependOnWhichCountOfEigenvaluesIsRequestedFirst) {
  const Shape cloud = test::random_points(test::sphere(1, 3), 400, 1);
  ProxySource few_first(cloud);
  ProxySource many_first(cloud);
  const Spectrum few = few_first.spectrum(10);
  const Spectrum many = many_first.spectrum(ProxySource::shared_eigenvalues + 5);
  EXPECT_EQ(many.eigenvalues.size(), ProxySource::shared_eigenvalues + 5);
  ASSERT_EQ(few.eigenvalues.size(), 10);
  ASSERT_EQ(few.eigenvectors.cols(), 10);
  EXPECT_EQ(few.eigenvectors.rows(), few_first.proxy().points.rows());
  EXPECT_EQ(many_first.spectrum(10).eigenvalues, few.eigenvalues);
  EXPECT_EQ(many_first.spectrum(10).eigenvectors, few.eigenvectors);
  // It is the beginning of any larger one.
  const Spectrum shared = few_first.spectrum(ProxySource::shared_eigenvalues);
  EXPECT_EQ(shared.eigenvalues.head(10), few.eigenvalues);
  EXPECT_EQ(shared.eigenvectors.leftCols(10), few.eigenvectors);
  EXPECT_TRUE(many.eigenvalues.head(10).isApprox(few.eigenvalues, 1e-6));
}

TEST(ProxySource, HasNoMoreEigenvaluesAndLandmarksThanPoints) {
  const Shape tetrahedron{Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}, {}};
  ProxySource source(tetrahedron);
  EXPECT_EQ(source.proxy().points.rows(), 4);
  EXPECT_EQ(source.spectrum(10).eigenvalues.size(), 4);
  EXPECT_EQ(source.geodesics().distances.cols(), 4);
  EXPECT_EQ(&source.proxy(), &source.proxy()) << "computed once";
  EXPECT_EQ(&source.geodesics(), &source.geodesics());
}

}  // namespace
}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/offset/mean_normals.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

constexpr double r = 0.2;

/// Computes the means at samples of a shape.
Points means_at(const Shape& shape, const Samples& samples) {
  const BlockGrid grid(bounding_box(shape), r, r / 3);
  const GridSurface surface(grid, shape, 0.75, false);
  const MeanNormals means(grid, shape, surface, false);
  Points result(samples.points.rows(), 3);
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    result.row(i) = means.at(grid.to_cells(samples.points.row(i).transpose()), samples.normals.row(i).transpose());
  }
  return result;
}

TEST(MeanNormals, OfAPlaneAreItsNormalForAnyOrientationOfFaces) {
  Shape box = test::box({2, 2, 2}, 6);
  for (Eigen::Index f = 0; f < box.triangles.rows(); f += 3) std::swap(box.triangles(f, 0), box.triangles(f, 1));
  const Samples samples = sample_shape(box, SampleSite::faces);
  const Points means = means_at(box, samples);
  int inner = 0;
  for (Eigen::Index i = 0; i < means.rows(); ++i) {
    // No other side within r/2.
    if ((samples.points.row(i).array().abs() > 1 - r / 2).count() > 1) continue;
    EXPECT_LT((means.row(i) - samples.normals.row(i)).norm(), 1e-5) << i;
    ++inner;
  }
  EXPECT_GT(inner, 50);
}

TEST(MeanNormals, OfASphereMatchAnAnalyticIntegral) {
  // Within a small angle a of the pole the mean of cos^2, weighted by (1 - (t/a)^2)^2, is 1 - a^2/4 to second order; a
  // is r/2, and the mean is computed twice.
  const Shape sphere = test::sphere(1, 5);
  const Samples samples = sample_shape(sphere, SampleSite::faces);
  const Points means = means_at(sphere, samples);
  for (Eigen::Index i = 0; i < means.rows(); i += 97) {
    EXPECT_NEAR(means.row(i).dot(samples.normals.row(i)), 1 - r * r / 8, 1e-3) << i;
    EXPECT_LT(means.row(i).cross(samples.normals.row(i)).norm(), 5e-3) << i;
  }
}

TEST(MeanNormals, OfANoisyPlaneLieBetweenTheNoisyAndTheTrueNormal) {
  Shape plane = test::box({2, 2, 0.5}, 40);
  RandomNumbers random(3, 0);
  for (Eigen::Index v = 0; v < plane.vertices.rows(); ++v) plane.vertices(v, 2) += random.uniform(-0.015, 0.015);
  const Samples samples = sample_shape(plane, SampleSite::faces);
  const Points means = means_at(plane, samples);
  double noisy = 0;
  double mean = 0;
  for (Eigen::Index i = 0; i < means.rows(); ++i) {
    if ((samples.points.row(i).head<2>().array().abs() > 1 - r / 2).any()) continue;
    noisy += 1 - std::abs(samples.normals(i, 2));
    mean += 1 - std::abs(means.row(i).normalized().z());
    EXPECT_LE(means.row(i).norm(), 1 + 1e-6);
  }
  EXPECT_LT(mean, noisy / 4);
}

/// Sums over all points: the definition.
Eigen::Vector3d literal_mean(const BlockGrid& grid, const Shape& shape, const GridSurface& surface,
                             const Eigen::Vector3d& p, const Eigen::Vector3d& n) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  double weights = 0;
  const double reach = grid.r / 2;
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const Eigen::Vector3f point(surface.points.x[i], surface.points.y[i], surface.points.z[i]);
    const double nearness = 1 - (point.cast<double>() - p).squaredNorm() / (reach * reach);
    if (nearness <= 0) continue;
    const Triangle t = triangle_in_cells(grid, shape, surface.points.triangle[i]);
    const Eigen::Vector3d normal = (t.b - t.a).cross(t.c - t.a).normalized();
    const double weight = nearness * nearness * static_cast<double>(surface.points.area[i]);
    sum += weight * normal * normal.transpose();
    weights += weight;
  }
  return sum * (sum * n) / (weights * weights);
}

TEST(MeanNormals, MatchTheWeightedSumOverAllPoints) {
  RandomNumbers random(4, 0);
  // Most triangles have one point, and several.
  for (const Shape& shape : {test::torus(1, 0.4, 120, 60), test::torus(1, 0.4, 15, 10)}) {
    const BlockGrid grid(bounding_box(shape), r, r / 3);
    const GridSurface surface(grid, shape, 0.75, false);
    const MeanNormals means(grid, shape, surface, false);
    const Samples samples = sample_shape(shape, SampleSite::faces);
    for (int round = 0; round < 200; ++round) {
      const auto i = static_cast<Eigen::Index>(random.below(static_cast<std::uint64_t>(samples.points.rows())));
      const Eigen::Vector3d p = grid.to_cells(samples.points.row(i).transpose());
      const Eigen::Vector3d n = samples.normals.row(i);
      EXPECT_LT((means.at(p, n) - literal_mean(grid, shape, surface, p, n)).norm(), 1e-4) << i;
    }
  }
}

TEST(MeanNormals, OfACloudAreItsNormals) {
  Shape cloud = test::sphere(1, 2);
  const Samples samples = sample_shape(cloud, SampleSite::vertices);
  cloud.triangles.resize(0, 3);
  EXPECT_EQ(means_at(cloud, samples), samples.normals);
}

}  // namespace
}  // namespace shapegauge

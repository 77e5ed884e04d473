// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "shapegauge/core/proxy/farthest_points.h"
#include "shapegauge/core/shape/connectivity.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using ::testing::ElementsAre;

DenseSamples samples_of(const Shape& shape, Eigen::Index count) {
  return dense_samples(shape, half_edges(shape.triangles, welded_vertices(shape.vertices)), count);
}

/// The definition of farthest_points() implemented literally, without blocks.
FarthestPoints literal_farthest_points(const DenseSamples& samples, Eigen::Index count) {
  const Eigen::Index size = samples.points.rows();
  const double always_covered = 0.01 * samples.areas.sum() / static_cast<double>(count);
  const Eigen::RowVector3d centroid = samples.areas.transpose() * samples.points / samples.areas.sum();
  Eigen::VectorXd squared = (samples.points.rowwise() - centroid).rowwise().squaredNorm();
  FarthestPoints result;
  result.nearest.assign(static_cast<std::size_t>(size), 0);
  while (std::ssize(result.chosen) < count) {
    Eigen::Index next = 0;
    if (!(squared.maxCoeff(&next) > 0)) break;
    if (result.chosen.empty()) squared.setConstant(std::numeric_limits<double>::infinity());
    for (Eigen::Index i = 0; i < size; ++i) {
      const double to_next = (samples.points.row(i) - samples.points.row(next)).squaredNorm();
      const double agreement = normal_agreement(samples, static_cast<std::int32_t>(i), static_cast<std::int32_t>(next));
      if (to_next < squared[i] && (to_next <= always_covered || agreement > 0.3)) {
        squared[i] = to_next;
        result.nearest[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(result.chosen.size());
      }
    }
    result.chosen.push_back(static_cast<std::int32_t>(next));
  }
  result.covering_radius = std::sqrt(squared.maxCoeff());
  return result;
}

class FarthestPointsOfShapes : public testing::TestWithParam<Shape> {};

TEST_P(FarthestPointsOfShapes, MatchADirectImplementation) {
  const DenseSamples samples = samples_of(GetParam(), 600);
  for (const Eigen::Index count : {1, 2, 40, 600}) {
    const FarthestPoints found = farthest_points(samples, count);
    const FarthestPoints expected = literal_farthest_points(samples, count);
    EXPECT_EQ(found.chosen, expected.chosen) << count;
    EXPECT_EQ(found.nearest, expected.nearest) << count;
    EXPECT_EQ(found.covering_radius, expected.covering_radius) << count;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, FarthestPointsOfShapes,
                         testing::Values(test::torus(1, 0.4, 20, 12), test::box({2, 1, 0.02}, 4), test::sphere(1, 2)),
                         [](const auto& one) { return "shape" + std::to_string(one.index); });

TEST(FarthestPoints, CoverBothSidesOfAThinWallSeparately) {
  const DenseSamples samples = samples_of(test::box({2, 1, 0.05}, 4), 600);
  const FarthestPoints found = farthest_points(samples, 40);
  const double tenth_of_spacing = 0.1 * std::sqrt(samples.areas.sum() / 40);
  ASSERT_LT(tenth_of_spacing, 0.05);
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    const auto by = found.chosen[static_cast<std::size_t>(found.nearest[static_cast<std::size_t>(i)])];
    const bool is_close = (samples.points.row(i) - samples.points.row(by)).norm() <= tenth_of_spacing;
    EXPECT_TRUE(is_close || samples.normals.row(i).dot(samples.normals.row(by)) > 0.3) << i;
    // Never across the wall.
    EXPECT_GT(samples.normals.row(i).dot(samples.normals.row(by)), -0.5) << i;
  }
}

TEST(FarthestPoints, AreAtMostAsManyAsDistinctPositions) {
  DenseSamples samples;
  samples.points = Points{{0, 0, 0}, {3, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  samples.normals = Points::Zero(4, 3);
  samples.normals.col(2).setOnes();
  samples.areas = Eigen::VectorXd::Ones(4);
  samples.sheets.assign(4, -1);
  const FarthestPoints found = farthest_points(samples, 4);
  EXPECT_THAT(found.chosen, ElementsAre(1, 0, 3));
  EXPECT_THAT(found.nearest, ElementsAre(1, 0, 1, 2));
  EXPECT_EQ(found.covering_radius, 0);
}

}  // namespace
}  // namespace shapegauge

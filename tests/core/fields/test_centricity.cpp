// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/fields/centricity.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using test::sphere;

Eigen::VectorXd at_vertices(const Shape& shape, const CentricityOptions& options = {}) {
  return centricity(shape, sample_shape(shape, SampleSite::vertices), options);
}

/// A flat disc of radius 1 about the origin, in rings.
Shape disc(int rings) {
  const int around = 6 * rings;
  Shape shape{.vertices = Points::Zero(1 + rings * around, 3), .triangles = {}};
  std::vector<Eigen::RowVector3i> triangles;
  const auto vertex = [around](int ring, int i) { return 1 + (ring - 1) * around + i % around; };
  for (int ring = 1; ring <= rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      shape.vertices.row(vertex(ring, i)) << std::cos(angle) * ring / rings, std::sin(angle) * ring / rings, 0;
      if (ring == 1) {
        triangles.emplace_back(0, vertex(1, i), vertex(1, i + 1));
      } else {
        triangles.emplace_back(vertex(ring - 1, i), vertex(ring, i), vertex(ring, i + 1));
        triangles.emplace_back(vertex(ring - 1, i), vertex(ring, i + 1), vertex(ring - 1, i + 1));
      }
    }
  }
  shape.triangles.resize(std::ssize(triangles), 3);
  for (std::size_t f = 0; f < triangles.size(); ++f) shape.triangles.row(static_cast<Eigen::Index>(f)) = triangles[f];
  return shape;
}

class CentricityByEachMethod : public testing::TestWithParam<GeodesicMethod> {};
INSTANTIATE_TEST_SUITE_P(All, CentricityByEachMethod,
                         testing::Values(GeodesicMethod::graph, GeodesicMethod::heat, GeodesicMethod::exact));

TEST_P(CentricityByEachMethod, OfASphereIsAQuarterOfItsCircumferenceEverywhere) {
  const Eigen::VectorXd values = at_vertices(sphere(2, 3), {.geodesics = {.method = GetParam()}});
  // Paths of the graph are up to 6 % too long; cells of sources are about 25 degrees wide.
  EXPECT_NEAR(values.mean(), std::numbers::pi, 0.05 * std::numbers::pi);
  EXPECT_NEAR(values.minCoeff(), std::numbers::pi, 0.1 * std::numbers::pi);
  EXPECT_NEAR(values.maxCoeff(), std::numbers::pi, 0.1 * std::numbers::pi);
}

TEST_P(CentricityByEachMethod, EccentricityOfASphereIsHalfItsCircumference) {
  const Eigen::VectorXd values =
      at_vertices(sphere(2, 3), {.measure = Centricity::eccentricity, .geodesics = {.method = GetParam()}});
  EXPECT_NEAR(values.maxCoeff(), 2 * std::numbers::pi, 0.1 * std::numbers::pi);
  // The source nearest to the antipode is at most half a cell from it.
  EXPECT_GT(values.minCoeff(), 2 * std::numbers::pi * 0.85);
}

TEST(CentricityOfDisc, IsTwoThirdsOfTheRadiusInTheMiddle) {
  const Eigen::VectorXd values = at_vertices(disc(12), {.sources = 200});
  EXPECT_NEAR(values[0], 2.0 / 3, 0.03);
  // From a point of the rim the mean distance is 32 / (9 pi).
  EXPECT_NEAR(values[values.size() - 1], 32 / (9 * std::numbers::pi), 0.06);
  EXPECT_NEAR(at_vertices(disc(12), {.measure = Centricity::eccentricity})[0], 1, 0.03);
}

TEST(CentricityOfDisc, IsTheMeanGeodesicDistanceIfAllVerticesAreSources) {
  const Shape shape = disc(4);
  const Samples samples = sample_shape(shape, SampleSite::vertices);
  const GeodesicDistances distances = geodesic_distances(shape);
  const Eigen::VectorXd found = at_vertices(shape, {.sources = 1000});
  for (const std::int32_t v : {0, 3, 50}) {
    EXPECT_NEAR(found[v], samples.weights.dot(distances(v)) / samples.weights.sum(), 1e-9);
  }
}

TEST(Centricity, IsSmallInTheMiddleOfAShapeAndLargeAtItsEnds) {
  const Shape bar = test::box({0.3, 0.3, 4}, 16);
  const Eigen::VectorXd values = at_vertices(bar);
  Eigen::Index least = 0;
  Eigen::Index most = 0;
  values.minCoeff(&least);
  values.maxCoeff(&most);
  EXPECT_LT(std::abs(bar.vertices(least, 2)), 0.4);
  EXPECT_GT(std::abs(bar.vertices(most, 2)), 1.9);
}

TEST(Centricity, IsProportionalToScaleAndIndependentOfVertexOrder) {
  const Shape shape = test::capsule(0.3, 1, 16, 20);
  const auto [other, vertices, triangles] = test::permuted(shape, 3);
  const Eigen::VectorXd expected = at_vertices(shape);
  const Eigen::VectorXd found = at_vertices(test::transformed(other, 5, test::rotation(1), {1, 0, 2}));
  // Ties between farthest points may be broken differently.
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    EXPECT_NEAR(found[static_cast<Eigen::Index>(v)], 5 * expected[vertices[v]], 0.05 * 5 * expected[vertices[v]]);
  }
}

TEST(Centricity, ValueInATriangleLiesBetweenThoseOfItsCorners) {
  const Shape shape = test::capsule(0.3, 1, 16, 20);
  const Eigen::VectorXd corners = at_vertices(shape);
  const Samples surface = sample_surface(shape, 500);
  const Eigen::VectorXd on_surface = centricity(shape, surface);
  for (Eigen::Index i = 0; i < on_surface.size(); ++i) {
    const Eigen::Index f = surface.triangles[static_cast<std::size_t>(i)];
    const Eigen::Vector3d of_corners = corners(shape.triangles.row(f));
    EXPECT_GE(on_surface[i], of_corners.minCoeff() - 1e-12);
    EXPECT_LE(on_surface[i], of_corners.maxCoeff() + 1e-12);
  }
  const Eigen::VectorXd at_faces = centricity(shape, sample_shape(shape, SampleSite::faces));
  EXPECT_NEAR(at_faces[0], corners(shape.triangles.row(0)).mean(), 1e-12);
}

TEST(Centricity, InterpolatesLinearFunctionsInTrianglesExactly) {
  const Shape shape = sphere(1, 1);
  const Samples surface = sample_surface(shape, 100);
  EXPECT_LT((interpolate_to_samples(shape, surface, shape.vertices) - surface.points).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Centricity, SampledPointsHaveTheValuesComputedForTheWholeCloud) {
  const Shape cloud = test::random_points(sphere(1, 2), 300, 1);
  const Samples some = sample_surface(cloud, 40);
  EXPECT_EQ(interpolate_to_samples(cloud, some, cloud.vertices), some.points);
  EXPECT_EQ(centricity(cloud, some), interpolate_to_samples(cloud, some, at_vertices(cloud)));
  EXPECT_THROW(centricity(test::random_points(sphere(1, 2), 300, 2), some), InputError);
}

TEST(Centricity, IsFiniteOnPointCloudsAndOnSeveralComponents) {
  const Shape ball = sphere(1, 3);
  EXPECT_NEAR(at_vertices(Shape{ball.vertices, {}}).mean(), std::numbers::pi / 2, 0.1 * std::numbers::pi / 2);
  const Shape pair = test::joined({ball, test::transformed(ball, 1, Eigen::Matrix3d::Identity(), {10, 0, 0})});
  EXPECT_TRUE(at_vertices(pair).allFinite());
}

TEST(Centricity, RejectsOptionsOutOfRange) {
  const Shape shape = sphere(1, 1);
  EXPECT_THROW(at_vertices(shape, {.sources = 0}), InputError);
  EXPECT_THROW(centricity(shape, sample_shape(sphere(1, 2), SampleSite::vertices)), InputError);
  EXPECT_THROW(at_vertices(Shape{Points::Zero(3, 3), {}}), InputError);
}

}  // namespace
}  // namespace shapegauge

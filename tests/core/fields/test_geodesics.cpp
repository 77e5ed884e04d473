// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/fields/geodesics.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using test::box;
using test::joined;
using test::permuted;
using test::soup;
using test::sphere;
using test::transformed;

GeodesicOptions by(GeodesicMethod method) { return {.method = method}; }

Shape cloud_of(const Shape& shape) { return {shape.vertices, {}}; }

/// Great-circle distances from a vertex of a sphere about the origin.
Eigen::VectorXd great_circles(const Shape& unit_sphere, Eigen::Index source) {
  const Eigen::VectorXd cosines = unit_sphere.vertices * unit_sphere.vertices.row(source).transpose();
  return cosines.unaryExpr([](double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); });
}

TEST(Geodesics, GraphPathsOnASphereAreAtMostAFewPercentTooLong) {
  const Shape shape = sphere(1, 4);
  const Eigen::VectorXd exact = great_circles(shape, 7);
  const Eigen::VectorXd found = geodesic_distances(shape)(7);
  // A polyhedron's paths are a little shorter than the sphere's: its edges are chords.
  EXPECT_GT((found - exact).minCoeff(), -0.005);
  EXPECT_LT((found.array() / exact.array().max(0.2)).maxCoeff(), 1.06);
  EXPECT_EQ(found[7], 0);
}

TEST(Geodesics, DistanceAcrossTheDiagonalsOfAGridIsExact) {
  const int n = 20;
  // Between the two corners without a diagonal, paths along edges are too long by a factor of sqrt 2.
  const Eigen::VectorXd found = geodesic_distances(test::rectangle(1, 1, n, n))(n);
  EXPECT_NEAR(found[n * (n + 1)], std::sqrt(2.0), 1e-9);
}

TEST(Geodesics, PathBendsAtAVertexIfTheStraightLineMissesTheEdge) {
  // The straight line between the corners opposite the edge passes beyond its upper end, or its lower one.
  for (const double sign : {1.0, -1.0}) {
    Shape kite{.vertices = Points{{0, -0.5, 0}, {0, 0.5, 0}, {-1, 1.5, 0}, {1, 2.5, 0}}, .triangles = {}};
    kite.vertices.col(1) *= sign;
    kite.triangles = Triangles{{0, 1, 2}, {1, 0, 3}};
    EXPECT_NEAR(geodesic_distances(kite)(2)[3], std::sqrt(2.0) + std::sqrt(5.0), 1e-12) << sign;
  }
}

TEST(Geodesics, HeatAndExactMethodsMatchGreatCirclesOnASphere) {
  const Shape shape = sphere(1, 3);
  const Eigen::VectorXd exact = great_circles(shape, 3);
  EXPECT_LT((geodesic_distances(shape, by(GeodesicMethod::exact))(3) - exact).cwiseAbs().maxCoeff(), 0.02);
  EXPECT_LT((geodesic_distances(shape, by(GeodesicMethod::heat))(3) - exact).cwiseAbs().maxCoeff(), 0.1);
}

TEST(Geodesics, GraphDistancesAreNeverShorterThanExactDistances) {
  const Shape shape = box({1, 2, 0.5}, 6);
  const Eigen::VectorXd exact = geodesic_distances(shape, by(GeodesicMethod::exact))(0);
  const Eigen::VectorXd graph = geodesic_distances(shape)(0);
  EXPECT_GT((graph - exact).minCoeff(), -1e-9);
  EXPECT_LT((graph - exact).maxCoeff(), 0.08 * exact.maxCoeff());
}

TEST(Geodesics, DistancesOnATriangleSoupMatchItsWeldedMesh) {
  const Shape shape = sphere(1, 2);
  const Shape pieces = soup(shape);
  for (const GeodesicMethod method : {GeodesicMethod::graph, GeodesicMethod::heat, GeodesicMethod::exact}) {
    const Eigen::VectorXd whole = geodesic_distances(shape, by(method))(shape.triangles(0, 0));
    const Eigen::VectorXd on_pieces = geodesic_distances(pieces, by(method))(0);
    for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
      EXPECT_NEAR(on_pieces[3 * f + 1], whole[shape.triangles(f, 1)], 1e-6);
    }
  }
}

TEST(Geodesics, DistancesScaleWithTheShapeAndIgnoreVertexOrder) {
  const Shape shape = box({1, 2, 0.5}, 4);
  const auto [other, vertices, triangles] = permuted(shape, 1);
  const Shape larger = transformed(other, 3, test::rotation(2), {1, 2, 3});
  const Eigen::VectorXd expected = 3 * geodesic_distances(shape)(vertices[5]);
  const Eigen::VectorXd found = geodesic_distances(larger)(5);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    EXPECT_NEAR(found[static_cast<Eigen::Index>(v)], expected[vertices[v]], 1e-9);
  }
}

TEST(Geodesics, DistancesInASphereCloudApproximateGreatCircles) {
  const Shape shape = sphere(1, 4);
  const Eigen::VectorXd found = geodesic_distances(cloud_of(shape))(0);
  EXPECT_LT((found - great_circles(shape, 0)).cwiseAbs().maxCoeff(), 0.06 * std::numbers::pi);
}

TEST(Geodesics, PathsJoinComponentsAtTheirNearestPoints) {
  const Shape ball = sphere(1, 3);
  const Shape far = transformed(ball, 1, Eigen::Matrix3d::Identity(), {10, 0, 0});
  const Shape pair = joined({ball, far});
  Eigen::Index leftmost = 0;
  Eigen::Index rightmost = 0;
  pair.vertices.col(0).minCoeff(&leftmost);
  pair.vertices.col(0).maxCoeff(&rightmost);
  const double distance = geodesic_distances(pair)(static_cast<std::int32_t>(leftmost))[rightmost];
  // Half a circle, the gap of 8, and half a circle; the bridge joins two of 64 probes of each, 0.4 from each other.
  EXPECT_NEAR(distance, 2 * std::numbers::pi + 8, 0.8);
}

TEST(Geodesics, DistancesAreFiniteAcrossAThousandComponents) {
  std::vector<Shape> pieces;
  for (int i = 0; i < 1000; ++i) {
    pieces.push_back(transformed(box({1, 1, 1}, 1), 0.1, test::rotation(static_cast<unsigned>(i)),
                                 {i % 10 * 1.0, i / 10 % 10 * 1.0, i / 100 * 1.0}));
  }
  const Eigen::VectorXd distances = geodesic_distances(joined(pieces))(0);
  EXPECT_TRUE(distances.allFinite());
  EXPECT_GT(distances.maxCoeff(), 9 * std::sqrt(3.0));
}

TEST(Geodesics, DistanceOfAnUnusedVertexIsMissing) {
  Shape shape = sphere(1, 1);
  shape.vertices.conservativeResize(shape.vertices.rows() + 1, 3);
  shape.vertices.bottomRows<1>() << 5, 5, 5;
  const Eigen::VectorXd distances = geodesic_distances(shape)(0);
  EXPECT_TRUE(std::isnan(distances[distances.size() - 1]));
  EXPECT_TRUE(distances.head(distances.size() - 1).allFinite());
}

TEST(Geodesics, HeatAndExactMethodsRejectNonManifoldShapes) {
  const Shape two = joined({sphere(1, 1), transformed(sphere(1, 1), 1, Eigen::Matrix3d::Identity(), {3, 0, 0})});
  Shape fin = sphere(1, 1);  // with a third triangle on an edge
  fin.vertices.conservativeResize(fin.vertices.rows() + 1, 3);
  fin.vertices.bottomRows<1>() << 5, 5, 5;
  fin.triangles.conservativeResize(fin.triangles.rows() + 1, 3);
  fin.triangles.bottomRows<1>() << fin.triangles(0, 0), fin.triangles(0, 1),
      static_cast<std::int32_t>(fin.vertices.rows() - 1);
  for (const GeodesicMethod method : {GeodesicMethod::heat, GeodesicMethod::exact}) {
    for (const Shape& shape : {two, fin, cloud_of(two)}) {
      EXPECT_THROW(geodesic_distances(shape, by(method)), InputError);
    }
  }
  EXPECT_THROW(geodesic_distances(two, {.neighbours = 0}), InputError);
  EXPECT_THROW(geodesic_distances(Shape{}), InputError);
}

}  // namespace
}  // namespace shapegauge

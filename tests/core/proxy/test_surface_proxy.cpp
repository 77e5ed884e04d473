// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/fields/geodesics.h"
#include "shapegauge/core/fields/laplacian.h"
#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/core/proxy/proxy_geodesics.h"
#include "shapegauge/core/proxy/surface_proxy.h"
#include "shapegauge/core/shape/point_cloud.h"
#include "tests/core/proxy/proxy_shapes.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using std::numbers::pi;
using test::sphere;

/// Non-zero eigenvalues times the area.
Eigen::VectorXd eigenvalues_of(const Shape& shape, Eigen::Index count) {
  ProxySource source(shape);
  return source.spectrum(static_cast<int>(count) + 1).eigenvalues.segment(1, count) * source.proxy().areas.sum();
}

double largest_relative_difference(const Eigen::VectorXd& found, const Eigen::VectorXd& expected) {
  return ((found - expected).array() / expected.array()).abs().maxCoeff();
}

bool is_joined(const SurfaceProxy& proxy, std::size_t i, std::int32_t j) {
  for (const ProxyArc& arc : proxy.arcs_of(i)) {
    if (arc.to == j) return true;
  }
  return false;
}

bool are_equal(const SurfaceProxy& a, const SurfaceProxy& b) {
  const auto arcs_equal = [](const ProxyArc& x, const ProxyArc& y) { return x.to == y.to && x.length == y.length; };
  return a.points == b.points && a.areas == b.areas && a.first_arc == b.first_arc &&
         std::equal(a.arcs.begin(), a.arcs.end(), b.arcs.begin(), b.arcs.end(), arcs_equal) &&
         Eigen::MatrixXd(a.stiffness) == Eigen::MatrixXd(b.stiffness);
}

TEST(SurfaceProxy, CoversTheSurfaceEvenly) {
  const SurfaceProxy proxy = surface_proxy(sphere(1, 5));
  ASSERT_EQ(proxy.points.rows(), 2000);
  EXPECT_EQ(proxy.components, 1);
  EXPECT_NEAR(proxy.areas.sum(), 4 * pi, 0.01 * 4 * pi);
  // Farthest points are a covering radius apart at least: discs of half of it do not overlap, of which a plane holds a
  // share of 0.9069 at most.
  const double closest = nearest_neighbours(proxy.points, 1).distances.minCoeff();
  EXPECT_GE(closest, proxy.covering_radius);
  EXPECT_LT(2000 * pi * closest * closest / 4, 0.9069 * 4 * pi);
  // A point's cell holds the disc of half the distance to its neighbours, and lies in that of the covering radius; in
  // between, its area is that of about 12 samples.
  EXPECT_GT(proxy.areas.minCoeff(), 0.5 * pi * closest * closest / 4);
  EXPECT_LT(proxy.areas.maxCoeff(), pi * proxy.covering_radius * proxy.covering_radius + 2 * 4 * pi / 24000);
  for (Eigen::Index i = 0; i < proxy.points.rows(); ++i) {
    ASSERT_GT(std::abs(proxy.normals.row(i).dot(proxy.points.row(i))), 0.99);
  }
}

TEST(SurfaceProxy, LaplacianIsSymmetricWithConstantsInItsKernel) {
  const SurfaceProxy proxy = surface_proxy(test::torus(2, 0.5, 24, 60));
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(proxy.areas.size());
  EXPECT_LT((proxy.stiffness * ones).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_EQ(Eigen::SparseMatrix<double>(proxy.stiffness.transpose()).toDense(), proxy.stiffness.toDense());
}

TEST(SurfaceProxy, EigenvaluesOfTheSphereMatchSphericalHarmonics) {
  const Eigen::VectorXd found = eigenvalues_of(sphere(3, 5), 35) / (4 * pi);
  Eigen::Index k = 0;
  for (int l = 1; l <= 5; ++l) {
    for (int m = -l; m <= l; ++m, ++k) EXPECT_NEAR(found[k], l * (l + 1), 0.03 * l * (l + 1)) << l << " " << m;
  }
}

TEST(SurfaceProxy, DistancesOnTheSphereMatchGreatCircles) {
  const SurfaceProxy proxy = surface_proxy(sphere(1, 5));
  const ProxyGeodesics geodesics = proxy_geodesics(proxy, 100);
  double sum = 0;
  double exact = 0;
  for (Eigen::Index landmark = 0; landmark < 100; ++landmark) {
    for (Eigen::Index i = 0; i < proxy.points.rows(); ++i) {
      const double angle = std::atan2(proxy.points.row(i).cross(proxy.points.row(landmark)).norm(),
                                      proxy.points.row(i).dot(proxy.points.row(landmark)));
      sum += geodesics.distances(i, landmark);
      exact += angle;
      ASSERT_NEAR(geodesics.distances(i, landmark), angle, 0.05 * angle + proxy.covering_radius);
    }
  }
  EXPECT_NEAR(sum / exact, 1, 0.03);
  EXPECT_NEAR(geodesics.areas.sum(), 4 * pi, 0.01 * 4 * pi);
}

TEST(SurfaceProxy, DistancesMatchExactGeodesicsOnTheMesh) {
  const Shape mesh = test::torus(1, 0.4, 40, 100);
  const SurfaceProxy proxy = surface_proxy(mesh);
  const ProxyGeodesics geodesics = proxy_geodesics(proxy, 3);
  const PointNeighbours vertices = nearest_among(proxy.points, mesh.vertices, 1);
  const GeodesicDistances exact_from = geodesic_distances(mesh, {.method = GeodesicMethod::exact});
  for (Eigen::Index landmark = 0; landmark < 3; ++landmark) {
    const Eigen::VectorXd exact = exact_from(vertices.indices(landmark, 0))(vertices.indices.col(0));
    EXPECT_NEAR(geodesics.distances.col(landmark).mean(), exact.mean(), 0.03 * exact.mean());
    for (Eigen::Index i = 0; i < exact.size(); ++i) {
      const double to_vertices = vertices.distances(i, 0) + vertices.distances(landmark, 0);
      ASSERT_NEAR(geodesics.distances(i, landmark), exact[i], 0.05 * exact[i] + proxy.covering_radius + to_vertices);
    }
  }
}

TEST(SurfaceProxy, EigenvaluesOfARectangleMatchCosines) {
  const Eigen::VectorXd found = eigenvalues_of(test::rectangle(2, 1, 40, 20), 5) / 2;
  const Eigen::VectorXd expected = Eigen::Vector<double, 5>(0.25, 1, 1, 1.25, 2) * pi * pi;
  EXPECT_LT(largest_relative_difference(found, expected), 0.03);
}

TEST(SurfaceProxy, DoesNotConnectTheSidesOfAThinPlate) {
  const double thickness = 0.01;
  const SurfaceProxy proxy = surface_proxy(test::box({1, 1, thickness}, 40));
  EXPECT_EQ(proxy.components, 1);
  for (std::size_t i = 0; i < 2000; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double to_rim = 0.5 - proxy.points.row(row).head<2>().cwiseAbs().maxCoeff();
    if (to_rim < 4 * proxy.covering_radius) continue;
    for (const ProxyArc& arc : proxy.arcs_of(i)) EXPECT_EQ(proxy.points(arc.to, 2), proxy.points(row, 2));
  }
}

TEST(SurfaceProxy, DistancesBetweenDisconnectedSheetsAreFinite) {
  Shape upper = test::rectangle(1, 1, 20, 20);
  upper.vertices.col(2).setConstant(0.05);
  const Shape sheets = test::joined({test::rectangle(1, 1, 20, 20), upper});
  const SurfaceProxy proxy = surface_proxy(sheets);
  EXPECT_EQ(proxy.components, 2);
  EXPECT_TRUE(proxy_geodesics(proxy, 10).distances.allFinite());
}

/// A flat ring of radii 1 and 1.2 that lacks a sector.
Shape open_ring(double missing_angle) {
  Shape ring = test::rectangle(1, 1, 300, 12);
  for (auto vertex : ring.vertices.rowwise()) {
    const double angle = (2 * pi - missing_angle) * vertex[0];
    const double radius = 1 + 0.2 * vertex[1];
    vertex = Eigen::RowVector3d(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return ring;
}

TEST(SurfaceProxy, DoesNotConnectTouchingParts) {
  const Shape ring = open_ring(0.001);
  const SurfaceProxy proxy = surface_proxy(ring);
  EXPECT_EQ(proxy.components, 1);
  for (std::size_t i = 0; i + 1 < proxy.first_arc.size(); ++i) {
    const auto from = proxy.points.row(static_cast<Eigen::Index>(i));
    for (const ProxyArc& arc : proxy.arcs_of(i)) {
      const auto to = proxy.points.row(arc.to);
      EXPECT_FALSE(from[0] > 0 && to[0] > 0 && from[1] * to[1] < 0) << from << " and " << to;
    }
  }
  const double longest = proxy_geodesics(proxy, 100).distances.maxCoeff();
  EXPECT_NEAR(longest, 2 * pi, 0.05 * 2 * pi);
}

TEST(SurfaceProxy, DoesNotConnectPartsAcrossGapsOfTheSampleSpacing) {
  // The gaps are as wide as neighbours are apart, and several times as wide as samples are.
  const SurfaceProxy cloud = surface_proxy(test::random_points(open_ring(0.03), 24000, 1));
  EXPECT_GT(2.5 * cloud.covering_radius, 0.036);
  EXPECT_NEAR(proxy_geodesics(cloud, 100).distances.maxCoeff(), 2 * pi, 0.05 * 2 * pi);
  Shape right = test::rectangle(1, 1, 20, 20);
  right.vertices.col(0).array() += 1.05;
  const SurfaceProxy halves = surface_proxy(test::joined({test::rectangle(1, 1, 20, 20), right}));
  EXPECT_GT(2.5 * halves.covering_radius, 0.05);
  EXPECT_EQ(halves.components, 2);
}

TEST(SurfaceProxy, EigenvaluesConvergeWithTheNumberOfPoints) {
  const Shape ball = sphere(1, 5);
  std::vector<double> errors;
  for (const int points : {250, 1000, 4000}) {
    const SurfaceProxy proxy = surface_proxy(ball, points);
    Laplacian laplacian{proxy.stiffness, proxy.areas, {}};
    for (std::int32_t i = 0; i < points; ++i) laplacian.node_of.push_back(i);
    const Eigen::VectorXd found = laplacian_spectrum(laplacian, 16).eigenvalues.segment(9, 7);  // 12, seven times
    errors.push_back((found.array() - 12).abs().mean() / 12);
  }
  EXPECT_LT(errors[1], 0.7 * errors[0]);
  EXPECT_LT(errors[2], 0.7 * errors[1]);
}

TEST(SurfaceProxy, EigenvaluesMatchTheCotangentLaplacian) {
  const Shape mesh = test::torus(1, 0.4, 40, 100);
  const Eigen::VectorXd expected = laplacian_spectrum(mesh, 21).eigenvalues.tail(20) * surface_area(mesh);
  EXPECT_LT(largest_relative_difference(eigenvalues_of(mesh, 20), expected), 0.03);
}

struct Damage {
  std::string name;
  Shape shape;
  double bound;  ///< of the relative change of an eigenvalue
};

TEST(SurfaceProxy, EigenvaluesAndDistancesHardlyChangeForDamagedMeshes) {
  const auto ellipsoid = [](int subdivisions) {
    Shape shape = sphere(1, subdivisions);
    shape.vertices = shape.vertices * Eigen::Vector3d(0.5, 0.7, 1.5).asDiagonal();
    return shape;
  };
  const Shape whole = ellipsoid(5);
  const std::vector<Damage> damages = {{"meshed anew", ellipsoid(4), 0.03},
                                       {"cracked", test::cracked(whole, 0.15, 1), 0.03},
                                       {"half flipped", test::half_flipped(whole, 1), 1e-12},
                                       {"soup", test::soup(whole), 0.03},
                                       {"cloud", test::random_points(whole, 10000, 1), 0.03}};
  const Eigen::VectorXd expected = eigenvalues_of(whole, 20);
  ProxySource source(whole);
  const double mean = source.geodesics().distances.mean();
  for (const Damage& damage : damages) {
    EXPECT_LT(largest_relative_difference(eigenvalues_of(damage.shape, 20), expected), damage.bound) << damage.name;
    ProxySource damaged(damage.shape);
    EXPECT_NEAR(damaged.geodesics().distances.mean(), mean, 0.03 * mean) << damage.name;
  }
}

TEST(SurfaceProxy, DoesNotDependOnTheOrderAndOrientationOfTriangles) {
  const Shape shape = test::joined({test::torus(1, 0.3, 20, 50), test::box({1, 2, 0.1}, 6)});
  const SurfaceProxy expected = surface_proxy(shape);
  EXPECT_TRUE(are_equal(surface_proxy(test::permuted(shape, 1).shape), expected));
  EXPECT_TRUE(are_equal(surface_proxy(test::flipped(shape)), expected));
  EXPECT_TRUE(are_equal(surface_proxy(test::half_flipped(shape, 2)), expected));
  EXPECT_TRUE(are_equal(surface_proxy(test::joined({shape, shape})), expected));  // duplicates count once
  const Shape cloud = test::random_points(shape, 5000, 1);
  EXPECT_TRUE(are_equal(surface_proxy(test::permuted(cloud, 3).shape), surface_proxy(cloud)));
}

TEST(SurfaceProxy, MovesAndScalesWithTheShape) {
  const Shape shape = test::capsule(0.5, 2, 20, 20);
  const SurfaceProxy small = surface_proxy(shape);
  const double scale =
      std::exp2(20);  // a power of two is exact; rounding would otherwise decide between equidistant points
  const SurfaceProxy large = surface_proxy(test::transformed(shape, scale, Eigen::Matrix3d::Identity(), {0, 0, 0}));
  EXPECT_TRUE(large.points.isApprox(scale * small.points, 1e-9));
  EXPECT_TRUE(large.areas.isApprox(scale * scale * small.areas, 1e-9));
  EXPECT_TRUE(large.stiffness.isApprox(small.stiffness, 1e-9));
}

TEST(SurfaceProxy, AcceptsASingleTriangleAndCloudsOfFewPoints) {
  const Shape triangle{.vertices = (Points(3, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0).finished(),
                       .triangles = (Triangles(1, 3) << 0, 1, 2).finished()};
  EXPECT_EQ(surface_proxy(triangle).components, 1);
  const Shape two{.vertices = (Points(2, 3) << 0, 0, 0, 1, 0, 0).finished(), .triangles = {}};
  const SurfaceProxy pair = surface_proxy(two);
  ASSERT_EQ(pair.points.rows(), 2);
  EXPECT_TRUE(is_joined(pair, 0, 1));
  const Shape few = test::random_points(sphere(1, 3), 50, 1);
  EXPECT_EQ(surface_proxy(few).points.rows(), 50);
  EXPECT_EQ(surface_proxy(test::random_points(sphere(1, 3), 500, 1)).components, 1);
  EXPECT_TRUE(eigenvalues_of(few, 20).allFinite());
}

TEST(SurfaceProxy, RejectsShapesWithoutArea) {
  EXPECT_THROW(surface_proxy(Shape{}), InputError);
  const Shape line{.vertices = (Points(3, 3) << 0, 0, 0, 1, 0, 0, 2, 0, 0).finished(),
                   .triangles = (Triangles(1, 3) << 0, 1, 2).finished()};
  EXPECT_THROW(surface_proxy(line), InputError);
  const Shape coincident{.vertices = Points::Ones(5, 3), .triangles = {}};
  EXPECT_THROW(surface_proxy(coincident), InputError);
}

}  // namespace
}  // namespace shapegauge

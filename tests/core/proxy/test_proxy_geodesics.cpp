// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "shapegauge/core/proxy/proxy_geodesics.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Shortest paths from a point, by relaxing all arcs until nothing changes (Bellman and Ford).
Eigen::VectorXf literal_distances(const SurfaceProxy& proxy, Eigen::Index source) {
  Eigen::VectorXf distances = Eigen::VectorXf::Constant(proxy.points.rows(), std::numeric_limits<float>::infinity());
  distances[source] = 0;
  for (bool changes = true; changes;) {
    changes = false;
    for (Eigen::Index i = 0; i < distances.size(); ++i) {
      for (const ProxyArc& arc : proxy.arcs_of(static_cast<std::size_t>(i))) {
        if (!(distances[i] + arc.length < distances[arc.to])) continue;
        distances[arc.to] = distances[i] + arc.length;
        changes = true;
      }
    }
  }
  return distances;
}

TEST(ProxyGeodesics, AreShortestPathsInTheGraphOfArcs) {
  const SurfaceProxy proxy = surface_proxy(test::torus(1, 0.4, 30, 16), 300);
  const ProxyGeodesics geodesics = proxy_geodesics(proxy, 37);  // not a multiple of the lanes
  ASSERT_EQ(geodesics.distances.cols(), 37);
  for (Eigen::Index landmark = 0; landmark < 37; ++landmark) {
    EXPECT_EQ(geodesics.distances.col(landmark), literal_distances(proxy, landmark)) << landmark;
  }
}

TEST(ProxyGeodesics, LandmarkAreasAreTheAreasOfTheirVoronoiCells) {
  const SurfaceProxy proxy = surface_proxy(test::sphere(1, 3), 400);
  const ProxyGeodesics geodesics = proxy_geodesics(proxy, 20);
  EXPECT_NEAR(geodesics.areas.sum(), proxy.areas.sum(), 1e-12 * proxy.areas.sum());
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(20);
  for (Eigen::Index i = 0; i < proxy.points.rows(); ++i) {
    Eigen::Index nearest = 0;
    for (Eigen::Index k = 1; k < 20; ++k) {
      if (geodesics.distances(i, k) < geodesics.distances(i, nearest)) nearest = k;
    }
    expected[nearest] += proxy.areas[i];
  }
  EXPECT_EQ(geodesics.areas, expected);
}

TEST(ProxyGeodesics, HaveAtMostOneLandmarkPerPoint) {
  const SurfaceProxy proxy = surface_proxy(test::sphere(1, 1), 30);
  EXPECT_EQ(proxy_geodesics(proxy, 1000).distances.cols(), proxy.points.rows());
}

TEST(ProxyGeodesics, AreAFewPercentLongerThanGreatCircles) {
  const SurfaceProxy proxy = surface_proxy(test::sphere(1, 4));
  const ProxyGeodesics geodesics = proxy_geodesics(proxy, 10);
  for (Eigen::Index k = 0; k < 10; ++k) {
    double ratio = 0;
    int count = 0;
    for (Eigen::Index i = 0; i < proxy.points.rows(); ++i) {
      const double angle =
          std::acos(std::clamp(proxy.points.row(i).normalized().dot(proxy.points.row(k).normalized()), -1.0, 1.0));
      if (angle < std::numbers::pi / 4) continue;
      ratio += static_cast<double>(geodesics.distances(i, k)) / angle;
      ++count;
    }
    EXPECT_GT(ratio / count, 1.0);
    EXPECT_LT(ratio / count, 1.08);
  }
}

}  // namespace
}  // namespace shapegauge

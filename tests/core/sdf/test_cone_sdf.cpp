// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

/// A direction in a cone: angle from the axis, angle about the axis.
struct ConeRay {
  double from_axis;
  double about_axis;
};

/// The definition, spelled out: rays through a spiral of N points on a disk of radius sin(half angle) at height
/// cos(half angle), the spiral's radius growing as i/N and its angle by the golden angle.
std::vector<ConeRay> cone_rays(double opening_degrees, int rays) {
  const double half = opening_degrees / 2 * std::numbers::pi / 180;
  std::vector<ConeRay> result;
  for (int i = 0; i < rays; ++i) {
    result.push_back({std::atan(std::tan(half) * i / rays), i * std::numbers::pi * (3 - std::sqrt(5.0))});
  }
  return result;
}

double sorted_median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

struct Expected {
  double mean = 0;
  double of_one_ray = 0;  ///< how far the mean moves if a ray at the limit is included or excluded
};

/// Mean of the distances that are within 1.5 median absolute deviations of the median.
Expected without_outliers(const std::vector<double>& distances) {
  const double median = sorted_median(distances);
  std::vector<double> deviations;
  for (const double d : distances) deviations.push_back(std::abs(d - median));
  const double limit = 1.5 * sorted_median(deviations);
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (deviations[i] > limit) continue;
    sum += distances[i];
    ++count;
  }
  return {.mean = sum / count, .of_one_ray = limit / count};
}

/// The cone's value for a surface on which a ray has the given length, the spiral begun at an angle `turn`.
Expected expected_value(const std::function<double(const ConeRay&)>& length, double turn = 0, double opening = 60,
                        int rays = 25) {
  std::vector<double> distances;
  for (ConeRay ray : cone_rays(opening, rays)) {
    ray.about_axis += turn;
    distances.push_back(length(ray));
  }
  return without_outliers(distances);
}

ConeSdfResult cone_sdf_at(const Shape& shape, SampleSite site, const ConeSdfOptions& options = {}) {
  return cone_sdf(shape, sample_shape(shape, site), options);
}

/// A mesh without symmetry to the axes, so that no ray meets an edge and no normal lies on an axis.
Shape generic(const Shape& shape) { return test::transformed(shape, 1.7, test::rotation(11), {3, -1, 2}); }

double largest_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

class ConeSdfAtEachSite : public testing::TestWithParam<SampleSite> {};
INSTANTIATE_TEST_SUITE_P(Both, ConeSdfAtEachSite, testing::Values(SampleSite::faces, SampleSite::vertices),
                         [](const auto& site) { return site.param == SampleSite::faces ? "faces" : "vertices"; });

double relative_error_on_sphere(int subdivisions, SampleSite site, const ConeSdfOptions& options, double expected) {
  const ConeSdfResult result = cone_sdf_at(test::sphere(2, subdivisions), site, options);
  EXPECT_EQ(result.missing, 0U);
  return (result.values.array() - expected).abs().mean() / expected;
}

/// A chord is too short by the depth of the mesh below the sphere at either end, along the ray: relative to the chord
/// at most depth / cos^2 for the ray furthest from the axis.
double chord_error_bound(int subdivisions, double opening) {
  const Samples centroids = sample_shape(test::sphere(1, subdivisions), SampleSite::faces);
  const double depth = 1 - centroids.points.rowwise().norm().minCoeff();
  const double cosine = std::cos(opening / 360 * std::numbers::pi);
  return depth / (cosine * cosine);
}

TEST_P(ConeSdfAtEachSite, OfASphereConvergesToTheMeanChordLength) {
  for (const double opening : {60.0, 120.0}) {
    for (const int rays : {1, 2}) {  // too few for outliers: the value depends smoothly on the mesh
      const auto chord = [](const ConeRay& ray) { return 4 * std::cos(ray.from_axis); };
      const double expected = expected_value(chord, 0, opening, rays).mean;
      ConeSdfOptions options;
      options.opening_angle_degrees = opening;
      options.rays = rays;
      double previous_error = std::numeric_limits<double>::infinity();
      for (const int subdivisions : {2, 3, 4}) {
        const double error = relative_error_on_sphere(subdivisions, GetParam(), options, expected);
        EXPECT_LT(error, previous_error / 3);  // the distance of the mesh to the sphere falls to a quarter each time
        previous_error = error;
      }
      EXPECT_LT(previous_error, chord_error_bound(4, opening));
    }
  }
}

TEST_P(ConeSdfAtEachSite, OfASphereIsTheMeanChordWithoutOutliers) {
  for (const double opening : {60.0, 120.0}) {
    for (const int rays : {25, 60}) {
      const auto chord = [](const ConeRay& ray) { return 4 * std::cos(ray.from_axis); };
      const Expected expected = expected_value(chord, 0, opening, rays);
      ConeSdfOptions options;
      options.opening_angle_degrees = opening;
      options.rays = rays;
      const double error = relative_error_on_sphere(4, GetParam(), options, expected.mean);
      EXPECT_LT(error, chord_error_bound(4, opening) + expected.of_one_ray / expected.mean);
    }
  }
}

TEST_P(ConeSdfAtEachSite, OfASlabIsTheMeanChordAwayFromItsRim) {
  const double thickness = 0.7;
  const Shape slab = test::box({20 * thickness, 20 * thickness, thickness}, 11);
  const Samples samples = sample_shape(slab, GetParam());
  const ConeSdfResult result = cone_sdf(slab, samples, {});
  const double expected = expected_value([&](const ConeRay& ray) { return thickness / std::cos(ray.from_axis); }).mean;
  int inner = 0;
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    if (samples.points.row(i).head<2>().cwiseAbs().maxCoeff() > 9 * thickness) continue;
    EXPECT_NEAR(result.values[i], expected, 1e-12);
    ++inner;
  }
  EXPECT_GT(inner, 100);
}

TEST_P(ConeSdfAtEachSite, IncludesRaysThatPassThroughEdgesOfTheOppositeSide) {
  // The rays from the vertices of one side pass exactly through vertices and edges of the other.
  const Shape slab = test::box({10, 10, 1}, 40);
  const Samples samples = sample_shape(slab, GetParam());
  const Eigen::VectorXd values = cone_sdf(slab, samples, {}).values;
  const double expected = expected_value([](const ConeRay& ray) { return 1 / std::cos(ray.from_axis); }).mean;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (samples.points.row(i).head<2>().cwiseAbs().maxCoeff() > 4) continue;
    EXPECT_NEAR(values[i], expected, 1e-12);
  }
}

TEST_P(ConeSdfAtEachSite, OfACapsuleIsTheMeanChordOnItsSide) {
  const double radius = 0.5;
  // In the cross-section a chord at an angle from the diameter; along the axis it is longer by the slope.
  const auto length = [&](const ConeRay& ray) {
    const double inward = std::cos(ray.from_axis);
    const double across = std::sin(ray.from_axis) * std::cos(ray.about_axis);
    return 2 * radius * inward / (inward * inward + across * across);
  };
  double lowest = std::numeric_limits<double>::infinity();
  double highest = 0;
  for (int i = 0; i < 720; ++i) {
    const double value = expected_value(length, 2 * std::numbers::pi * i / 720).mean;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  const Shape capsule = test::capsule(radius, 10, 128, 16);
  const Samples samples = sample_shape(capsule, GetParam());
  const ConeSdfResult result = cone_sdf_at(generic(capsule), GetParam());
  for (Eigen::Index i = 0; i < result.values.size(); ++i) {
    if (std::abs(samples.points(i, 2)) > 3.5) continue;
    EXPECT_GT(result.values[i] / 1.7, lowest - 1e-3 * radius);
    EXPECT_LT(result.values[i] / 1.7, highest + 1e-3 * radius);
  }
}

TEST_P(ConeSdfAtEachSite, ScalesWithTheShapeAndIgnoresTranslation) {
  const Shape torus = generic(test::torus(3, 1, 20, 40));
  const ConeSdfResult expected = cone_sdf_at(torus, GetParam());
  ASSERT_EQ(expected.missing, 0U);
  for (const double scale : {1e-30, 1e-6, 1e30}) {
    const Eigen::Vector3d move = scale * Eigen::Vector3d(100, -200, 50);
    const Shape moved = test::transformed(torus, scale, Eigen::Matrix3d::Identity(), move);
    const ConeSdfResult result = cone_sdf_at(moved, GetParam());
    EXPECT_LT(largest_difference(result.values / scale, expected.values), 1e-9) << scale;
  }
}

TEST_P(ConeSdfAtEachSite, MeanChangesByLessThanOnePercentUnderRotation) {
  const Shape torus = test::torus(3, 1, 40, 80);
  const ConeSdfResult before = cone_sdf_at(torus, GetParam());
  for (unsigned seed = 1; seed < 4; ++seed) {
    const Shape turned = test::transformed(torus, 1, test::rotation(seed), {1, 2, 3});
    const ConeSdfResult after = cone_sdf_at(turned, GetParam());
    // The 25 rays have other directions in the same cone: single values change, their mean hardly.
    EXPECT_NEAR(after.values.mean() / before.values.mean(), 1, 5e-3);
  }
  const Shape sphere = test::sphere(1, 4);
  const Shape turned = test::transformed(sphere, 1, test::rotation(1), {1, 2, 3});
  EXPECT_LT(largest_difference(cone_sdf_at(sphere, GetParam()).values, cone_sdf_at(turned, GetParam()).values), 1e-2);
}

TEST_P(ConeSdfAtEachSite, FollowsTheOrderOfTrianglesAndVertices) {
  const Shape torus = generic(test::torus(3, 1, 20, 40));
  const test::Permuted permuted = test::permuted(torus, 3);
  const Eigen::VectorXd before = cone_sdf_at(torus, GetParam()).values;
  const Eigen::VectorXd after = cone_sdf_at(permuted.shape, GetParam()).values;
  const auto& order = GetParam() == SampleSite::faces ? permuted.triangles : permuted.vertices;
  for (Eigen::Index i = 0; i < after.size(); ++i) EXPECT_NEAR(after[i], before[order[i]], 1e-9);
}

TEST_P(ConeSdfAtEachSite, IsMissingOnAConvexShapeTurnedInsideOut) {
  const Shape box = test::flipped(test::box({1, 2, 3}, 3));
  const ConeSdfResult result = cone_sdf_at(box, GetParam());
  EXPECT_TRUE(result.values.array().isNaN().all());
  EXPECT_EQ(result.missing, static_cast<std::size_t>(result.values.size()));
}

TEST(ConeSdf, IgnoresHitsOnReversedFaces) {
  Shape slab = test::box({20, 20, 1}, 4);
  const Samples samples = sample_shape(slab, SampleSite::faces);
  for (Eigen::Index f = 0; f < slab.triangles.rows(); ++f) {
    if (samples.normals(f, 2) > 0.5) std::swap(slab.triangles(f, 1), slab.triangles(f, 2));
  }
  const ConeSdfResult result = cone_sdf_at(slab, SampleSite::faces);
  for (Eigen::Index f = 0; f < slab.triangles.rows(); ++f) {
    const bool on_a_large_side = std::abs(samples.normals(f, 2)) > 0.5;
    EXPECT_EQ(std::isnan(result.values[f]), on_a_large_side) << f;
  }
}

/// A tetrahedron whose first face has its centroid in the origin, and an edge from that face's first vertex through the
/// point.
Shape tetrahedron_with_edge_through(const Eigen::RowVector3d& point, const std::function<double(double, double)>& any) {
  Shape shape;
  shape.vertices.resize(4, 3);
  for (int k = 0; k < 2; ++k) {
    const double turn = 2 * std::numbers::pi / 3 * (k + any(0, 0.5));
    shape.vertices.row(k) << std::cos(turn), std::sin(turn), 0;
  }
  shape.vertices.row(2) = -shape.vertices.row(0) - shape.vertices.row(1);
  shape.vertices.row(3) = shape.vertices.row(0) + any(1.1, 3) * (point - shape.vertices.row(0));
  shape.triangles = Triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return shape;
}

TEST(ConeSdf, IncludesRaysThatHitAnEdge) {
  std::mt19937 random(1);
  const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const ConeRay ray = cone_rays(60, 2)[1];
  const double out = std::tan(ray.from_axis);
  const Eigen::RowVector3d along_ray(out * std::cos(ray.about_axis), out * std::sin(ray.about_axis), 1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::RowVector3d point = any(0.5, 2) * along_ray;
    const Shape shape = tetrahedron_with_edge_through(point, any);
    const auto at_the_base = [&](int rays) { return cone_sdf_at(shape, SampleSite::faces, {.rays = rays}).values[0]; };
    EXPECT_NEAR(at_the_base(2), (at_the_base(1) + point.norm()) / 2, 1e-4) << i;
  }
}

TEST(ConeSdf, DoesNotChangeIfAllFacesAreDuplicated) {
  const Shape torus = generic(test::torus(3, 1, 20, 40));
  const Eigen::VectorXd once = cone_sdf_at(torus, SampleSite::faces).values;
  const Eigen::VectorXd twice = cone_sdf_at(test::joined({torus, torus}), SampleSite::faces).values;
  EXPECT_EQ(twice.head(once.size()), once);
  EXPECT_EQ(twice.tail(once.size()), once);
}

TEST(ConeSdf, IsNanAndCountedAsMissingForDegenerateTriangles) {
  Shape sphere = test::sphere(1, 2);
  const ConeSdfResult before = cone_sdf_at(sphere, SampleSite::faces);
  const Eigen::Index count = sphere.triangles.rows();
  sphere.triangles.conservativeResize(count + 2, 3);
  sphere.triangles.bottomRows<2>() << 0, 0, 0, 1, 2, 1;
  const ConeSdfResult result = cone_sdf_at(sphere, SampleSite::faces);
  EXPECT_EQ(result.missing, 2U);
  EXPECT_TRUE(result.values.tail<2>().array().isNaN().all());
  EXPECT_EQ(result.values.head(count), before.values);
}

TEST(ConeSdf, IgnoresHitsAtTheRayOriginInATriangleSoup) {
  const ConeSdfResult result = cone_sdf_at(test::soup(test::sphere(1, 3)), SampleSite::vertices);
  EXPECT_EQ(result.missing, 0U);
  EXPECT_GT(result.values.minCoeff(), 1.8);
}

TEST(ConeSdf, IsMissingAtUnusedVertices) {
  Shape sphere = test::sphere(1, 2);
  sphere.vertices.conservativeResize(sphere.vertices.rows() + 1, 3);
  sphere.vertices.bottomRows<1>() << 0.1, 0.2, 0.3;
  const ConeSdfResult result = cone_sdf_at(sphere, SampleSite::vertices);
  EXPECT_EQ(result.missing, 1U);
  EXPECT_TRUE(std::isnan(result.values.tail<1>()[0]));
}

TEST(ConeSdf, RefusesOptionsOutOfRange) {
  const Shape sphere = test::sphere(1, 1);
  const auto with = [&](double angle, int rays) {
    ConeSdfOptions options;
    options.opening_angle_degrees = angle;
    options.rays = rays;
    return cone_sdf_at(sphere, SampleSite::faces, options);
  };
  for (const double angle : {0.0, -1.0, 180.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(with(angle, 25), InputError) << angle;
  }
  EXPECT_THROW(with(60, 0), InputError);
  EXPECT_THROW(with(60, 10'001), InputError);
  EXPECT_NO_THROW(with(179, 1));
}

TEST(ConeSdf, RejectsCloudsEmptyShapesAndSamplesOfAnotherMesh) {
  const Shape sphere = test::sphere(1, 1);
  ConeSdfOptions options;
  options.postprocess = true;
  EXPECT_THROW(cone_sdf_at(sphere, SampleSite::faces, options), InputError);
  EXPECT_THROW(cone_sdf_at(Shape{}, SampleSite::faces), InputError);
  const Shape cloud{sphere.vertices, {}, {}};
  for (const ConeSdfEngine engine : {ConeSdfEngine::embree, ConeSdfEngine::cgal}) {
    for (const SampleSite site : {SampleSite::faces, SampleSite::vertices}) {
      EXPECT_THAT([&] { cone_sdf(cloud, sample_shape(cloud, site), {.engine = engine}); },
                  testing::ThrowsMessage<InputError>(testing::StartsWith("the conventional SDF needs triangles")));
    }
  }
  EXPECT_THROW(cone_sdf(sphere, sample_shape(test::sphere(1, 2), SampleSite::faces), {}), InputError);
}

}  // namespace

}  // namespace shapegauge

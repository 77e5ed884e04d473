// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/preparation/denoise.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::IsEmpty;

VertexNeighbours vertex_neighbours(const Shape& shape) { return vertex_neighbours(shape, welding_of(shape)); }

TEST(VertexNeighbours, AreTheVerticesOfAdjacentTriangles) {
  const Shape shape{.vertices = Points{{0, 0, 0}, {1, 0, 0}, {9, 9, 9}, {1, 1, 0}, {0, 1, 0}},
                    .triangles = Triangles{{0, 1, 3}, {4, 3, 0}}};
  const VertexNeighbours neighbours = vertex_neighbours(shape);
  EXPECT_THAT(neighbours.of(0), ElementsAre(1, 3, 4));
  EXPECT_THAT(neighbours.of(1), ElementsAre(0, 3));
  EXPECT_THAT(neighbours.of(2), IsEmpty());
  EXPECT_THAT(neighbours.of(3), ElementsAre(0, 1, 4));
  EXPECT_THAT(neighbours.of(4), ElementsAre(0, 3));
}

TEST(VertexNeighbours, OfATorusAreSixPerVertex) {
  const Shape torus = test::torus(2, 0.7, 8, 12);
  const VertexNeighbours neighbours = vertex_neighbours(torus);
  for (Eigen::Index v = 0; v < torus.vertices.rows(); ++v) EXPECT_EQ(neighbours.of(v).size(), 6U) << v;
}

TEST(VertexNeighbours, OfATriangleSoupMatchItsWeldedMesh) {
  const Shape torus = test::torus(2, 0.7, 8, 12);
  const Shape soup = test::soup(torus);
  const VertexNeighbours expected = vertex_neighbours(torus);
  const VertexNeighbours found = vertex_neighbours(soup);
  for (Eigen::Index v = 0; v < soup.vertices.rows(); ++v) {
    std::vector<std::int32_t> vertices;  // the neighbours by the mesh's indices
    for (const std::int32_t u : found.of(v)) vertices.push_back(torus.triangles(u / 3, u % 3));
    std::ranges::sort(vertices);
    EXPECT_THAT(vertices, ElementsAreArray(expected.of(torus.triangles(v / 3, v % 3)))) << v;
  }
}

TEST(VertexNeighbours, AreEmptyForCloudsAndEmptyShapes) {
  const Shape cloud{test::sphere(1, 1).vertices, {}};
  const VertexNeighbours neighbours = vertex_neighbours(cloud);
  for (Eigen::Index v = 0; v < cloud.vertices.rows(); ++v) EXPECT_THAT(neighbours.of(v), IsEmpty());
  EXPECT_THAT(vertex_neighbours({}).neighbours, IsEmpty());
}

TEST(Denoise, RefusesATriangleWithAnInvalidIndex) {
  Shape shape = test::sphere(1, 0);
  shape.triangles(3, 1) = 12;
  EXPECT_THROW(denoised(shape), InputError);
}

NoiseLevel level_of(const Shape& shape) { return noise_level(shape, vertex_neighbours(shape), welding_of(shape)); }

bool is_noisy(const Shape& shape) { return is_noisy(level_of(shape), vertex_neighbours(shape)); }

/// Noise along the normal only, of that standard deviation.
Shape with_normal_noise(Shape sphere, double deviation) {
  RandomNumbers random(5);
  for (Eigen::Index i = 0; i < sphere.vertices.rows(); ++i) {
    sphere.vertices.row(i) *= 1 + deviation * gaussian_vector(random).x() / sphere.vertices.row(i).norm();
  }
  return sphere;
}

/// Noise in all directions, of that standard deviation along each.
Shape with_isotropic_noise(const Shape& shape, double deviation) {
  RandomNumbers random(3);
  return vertex_noise(
      shape, {.amplitude = deviation / bounding_box_diagonal(shape), .distribution = NoiseDistribution::gaussian},
      random);
}

TEST(NoiseLevel, MatchesTheNoiseAddedToASphere) {
  // The estimate's own error: 1.2 / sqrt(n), 1 % here; what the smoothing keeps of the noise lowers it by some per
  // cent. An edge is 0.038 long.
  const Shape sphere = test::sphere(1, 5);
  for (const double deviation : {0.003, 0.008, 0.015}) {
    for (const Shape& noisy : {with_isotropic_noise(sphere, deviation), with_normal_noise(sphere, deviation)}) {
      const NoiseLevel level = level_of(noisy);
      EXPECT_NEAR(level.deviation, deviation, 0.08 * deviation);
      EXPECT_NEAR(level.edge_length, 0.037, 0.002);
      EXPECT_LT(level.agreement, 0.5);
      EXPECT_EQ(is_noisy(noisy), deviation > 0.004) << level.relative();
    }
  }
}

TEST(NoiseLevel, IsZeroOnCleanShapes) {
  const std::vector<Shape> clean = {
      test::sphere(1, 3),
      test::sphere(1, 5),
      test::torus(2, 0.7, 60, 120),
      test::torus(2, 0.7, 12, 50),  // long triangles
      test::box({1, 2, 3}, 12),
      test::box({1, 1, 1}, 30),
      test::box({1, 40, 0.01}, 12),  // a strip of needles
      test::capsule(0.5, 4, 48, 12),
      test::capsule(0.5, 400, 48, 12),
      test::joined({test::box({1, 1, 5}, 10), test::box({5, 1, 1}, 10)}),
  };
  for (std::size_t i = 0; i < clean.size(); ++i) EXPECT_FALSE(is_noisy(clean[i])) << i;
}

TEST(NoiseLevel, DoesNotDependOnTheOrientation) {
  const Shape noisy = with_isotropic_noise(test::torus(2, 0.7, 40, 80), 0.02);
  RandomNumbers random(1);
  const NoiseLevel clean = level_of(noisy);
  for (const Shape& turned : {test::flipped(noisy), flip_orientation(noisy, 0.5, random)}) {
    const NoiseLevel level = level_of(turned);
    EXPECT_NEAR(level.deviation, clean.deviation, 1e-9 * clean.deviation);
    EXPECT_EQ(level.edge_length, clean.edge_length);
    EXPECT_NEAR(level.agreement, clean.agreement, 1e-3);  // normals across each other are alike by their signs only
  }
}

TEST(NoiseLevel, ScalesWithTheShapeAndIgnoresTranslation) {
  const Shape noisy = with_isotropic_noise(test::torus(2, 0.7, 40, 80), 0.02);
  const NoiseLevel level = level_of(noisy);
  for (const double scale : {1e-30, 1e-4, 1e30}) {
    const Shape moved = test::transformed(noisy, scale, test::rotation(2), scale * Eigen::Vector3d(5, 6, 7));
    const NoiseLevel found = level_of(moved);
    EXPECT_NEAR(found.deviation / scale, level.deviation, 1e-9 * level.deviation);
    EXPECT_NEAR(found.edge_length / scale, level.edge_length, 1e-9 * level.edge_length);
    EXPECT_NEAR(found.agreement, level.agreement, 1e-3);
  }
}

TEST(NoiseLevel, OfATriangleSoupMatchesItsWeldedMesh) {
  // Each vertex counts as often as it has triangles, six times as a rule.
  const Shape noisy = with_isotropic_noise(test::torus(2, 0.7, 40, 80), 0.02);
  const NoiseLevel mesh = level_of(noisy);
  const NoiseLevel soup = level_of(test::soup(noisy));
  EXPECT_NEAR(soup.deviation, mesh.deviation, 1e-6 * mesh.deviation);
  EXPECT_NEAR(soup.agreement, mesh.agreement, 1e-6);
  EXPECT_TRUE(is_noisy(test::soup(noisy)));
  const Shape far = test::transformed(test::soup(test::sphere(1, 3)), 1, Eigen::Matrix3d::Identity(), {1e7, 1e7, 1e7});
  EXPECT_FALSE(is_noisy(far));
}

TEST(NoiseLevel, OfAMeshOfFewVerticesDoesNotCountAsNoisy) {
  const Shape few = with_isotropic_noise(test::sphere(1, 2), 0.1);  // 162 vertices
  EXPECT_GE(level_of(few).relative(), 0.1);
  EXPECT_FALSE(is_noisy(few));
  Shape padded = few;
  padded.vertices.conservativeResize(1000, 3);
  padded.vertices.bottomRows(1000 - 162).setOnes();
  EXPECT_FALSE(is_noisy(padded));
  EXPECT_FALSE(is_noisy(test::soup(few)));
}

TEST(NoiseLevel, IsZeroForACloud) {
  const NoiseLevel level = level_of({test::sphere(1, 3).vertices, {}});
  EXPECT_EQ(level.deviation, 0);
  EXPECT_EQ(level.edge_length, 0);
  EXPECT_EQ(level.relative(), 0);
}

/// The factor that the documentation promises for a frequency.
double gain(double k, double pass_band) {
  const double rounds = std::ceil(2 / pass_band) + 3;
  return std::pow((1 - k / 2) * (1 + k / (2 - pass_band)), rounds);
}

/// A ring of vertices that are each other's neighbours.
VertexNeighbours ring(std::int32_t n) {
  VertexNeighbours result;
  for (std::int32_t v = 0; v < n; ++v) {
    result.first.push_back(result.neighbours.size());
    result.neighbours.push_back((v + n - 1) % n);
    result.neighbours.push_back((v + 1) % n);
  }
  result.first.push_back(result.neighbours.size());
  return result;
}

TEST(TaubinSmoothing, ScalesAWaveOnARingByTheTransferFunction) {
  constexpr int n = 60;
  for (const double pass_band : {0.02, 0.1, 0.3}) {
    for (const int waves : {0, 1, 3, 7, 12, 20, 30}) {
      const double k = 1 - std::cos(2 * std::numbers::pi * waves / n);
      Points values(n, 3);
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * waves * i / n;
        values.row(i) << std::cos(angle), std::sin(angle), 5;
      }
      const Points smoothed = taubin_smoothing(values, ring(n), pass_band);
      values.leftCols(2) *= gain(k, pass_band);
      EXPECT_LT((smoothed - values).cwiseAbs().maxCoeff(), 1e-12) << pass_band << " " << waves;
    }
  }
}

TEST(TaubinSmoothing, ScalesAWaveOnATorusMeshByTheTransferFunction) {
  constexpr int around = 24;
  constexpr int along = 36;
  const VertexNeighbours neighbours = vertex_neighbours(test::torus(2, 0.7, around, along));
  for (const auto& [p, q] : {std::pair(1, 0), std::pair(2, 3), std::pair(5, 7), std::pair(18, 12)}) {
    const double a = 2 * std::numbers::pi * p / along;
    const double b = 2 * std::numbers::pi * q / around;
    // The diagonals join (i, j) and (i + 1, j + 1).
    const double k = 1 - (std::cos(a) + std::cos(b) + std::cos(a + b)) / 3;
    Points values = Points::Zero(along * around, 3);
    for (int i = 0; i < along; ++i) {
      for (int j = 0; j < around; ++j) values(i * around + j, 0) = std::cos(a * i + b * j);
    }
    const Points smoothed = taubin_smoothing(values, neighbours, 0.1);
    EXPECT_LT((smoothed - gain(k, 0.1) * values).cwiseAbs().maxCoeff(), 1e-12) << p << " " << q;
  }
}

TEST(TaubinSmoothing, KeepsOnlyFrequenciesOfThePassBand) {
  for (const double pass_band : {0.01, 0.02, 0.05, 0.1}) {
    for (int i = 0; i < 200; ++i) {
      const double k = 0.01 * i;
      if (k < pass_band) {
        EXPECT_GE(gain(k, pass_band), 1 - 1e-12);
        EXPECT_LE(gain(k, pass_band), 1.02);
      } else {
        EXPECT_LE(std::abs(gain(k, pass_band)), 1 + 1e-12);
      }
      if (k > 0.75) {
        EXPECT_LE(std::abs(gain(k, pass_band)), 0.1);
      }
    }
  }
}

TEST(TaubinSmoothing, DoesNotShrinkASphere) {
  const Shape sphere = test::sphere(1, 4);
  const Points smoothed = taubin_smoothing(sphere.vertices, vertex_neighbours(sphere), 0.1);
  // As many rounds of plain averaging take 3 % off.
  EXPECT_NEAR(smoothed.rowwise().norm().mean(), 1, 3e-3);
  EXPECT_LT((smoothed - sphere.vertices).rowwise().norm().maxCoeff(), 1e-2);
}

TEST(TaubinSmoothing, KeepsIsolatedVerticesAndMovesCoincidentVerticesTogether) {
  Shape soup = test::soup(test::box({1, 2, 3}, 3));
  soup.vertices.conservativeResize(soup.vertices.rows() + 1, 3);
  soup.vertices.bottomRows(1) << 0.1, 0.2, 0.3;
  const Points smoothed = taubin_smoothing(soup.vertices, vertex_neighbours(soup), 0.1);
  EXPECT_EQ(smoothed.bottomRows(1), soup.vertices.bottomRows(1));
  const Shape mesh = test::box({1, 2, 3}, 3);
  const Points expected = taubin_smoothing(mesh.vertices, vertex_neighbours(mesh), 0.1);
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i) {
    EXPECT_LT((smoothed.row(i) - expected.row(mesh.triangles(i / 3, i % 3))).norm(), 1e-12);
  }
}

TEST(TaubinSmoothing, RefusesAPassBandOutOfRange) {
  for (const double pass_band : {0.0, 1.0, -0.1, std::nan("")}) {
    EXPECT_THROW(taubin_smoothing(Points::Zero(60, 3), ring(60), pass_band), InputError);
  }
}

/// Root of the mean squared distance of the vertices from the unit sphere.
double distance_from_sphere(const Shape& shape) {
  return std::sqrt((shape.vertices.rowwise().norm().array() - 1).square().mean());
}

TEST(Denoise, MovesNoisyVerticesTowardsTheSphere) {
  // By how much, at least, for noise of a fraction of the diagonal: 3.1, 3.9, 4.7 and 5.2 times as measured. The edges
  // are 0.011 of the diagonal long.
  const Shape sphere = test::sphere(1, 5);
  for (const auto& [noise, factor] : {std::pair(0.0025, 2.8), {0.005, 3.5}, {0.01, 4.2}, {0.02, 4.6}}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      RandomNumbers random(seed);
      const Shape noisy =
          vertex_noise(sphere, {.amplitude = noise, .distribution = NoiseDistribution::gaussian}, random);
      const DenoisedShape result = denoised(noisy);
      EXPECT_GT(result.pass_band, 0);
      EXPECT_GT(result.noise.deviation, 0);
      EXPECT_EQ(result.shape.triangles, noisy.triangles);
      EXPECT_LT(distance_from_sphere(result.shape), distance_from_sphere(noisy) / factor) << noise << " " << seed;
    }
  }
}

TEST(Denoise, SmoothsInProportionToTheNoise) {
  // 0.025 / (noise in edge lengths); an edge is 0.0107 of the diagonal long.
  const Shape sphere = test::sphere(1, 5);
  for (const auto& [noise, pass_band] : {std::pair(0.0025, 0.107), {0.005, 0.0535}, {0.05, 0.02}}) {
    RandomNumbers random(1);
    const Shape noisy = vertex_noise(sphere, {.amplitude = noise, .distribution = NoiseDistribution::gaussian}, random);
    EXPECT_NEAR(denoised(noisy).pass_band, pass_band, 0.15 * pass_band) << noise;
  }
}

TEST(Denoise, KeepsCleanShapesAndCloudsUnchanged) {
  for (const Shape& shape : {test::sphere(1, 4), test::torus(2, 0.7, 30, 60), test::box({1, 2, 3}, 12),
                             test::capsule(0.5, 400, 48, 12), test::random_points(test::sphere(1, 4), 3000, 1)}) {
    const DenoisedShape result = denoised(shape);
    EXPECT_EQ(result.shape.vertices, shape.vertices);
    EXPECT_EQ(result.shape.triangles, shape.triangles);
    EXPECT_EQ(result.pass_band, 0);
  }
}

TEST(Denoise, MovesCoincidentVerticesOfATriangleSoupTogether) {
  RandomNumbers random(1);
  const Shape noisy = vertex_noise(test::sphere(1, 4), {.amplitude = 0.01}, random);
  const DenoisedShape mesh = denoised(noisy);
  const DenoisedShape soup = denoised(test::soup(noisy));
  const Shape expected = test::soup(mesh.shape);
  EXPECT_LT((soup.shape.vertices - expected.vertices).rowwise().norm().maxCoeff(), 1e-3);
}

}  // namespace

}  // namespace shapegauge

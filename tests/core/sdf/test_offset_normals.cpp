// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Angles in degrees between normals and the directions from the origin.
Eigen::ArrayXd errors_on_sphere(const Points& points, const Points& normals) {
  const Eigen::ArrayXd cosines = points.rowwise().normalized().cwiseProduct(normals).rowwise().sum().array();
  return cosines.min(1).max(-1).acos() * (180 / std::numbers::pi);
}

Points normals_of(const Shape& shape, const Samples& samples, double offset) {
  const OffsetSdfResult result = offset_sdf(shape, samples, {.offset = offset});
  EXPECT_EQ(result.outcomes.total, static_cast<std::size_t>(samples.points.rows()));
  EXPECT_EQ(result.outcomes.missing, 0U);
  EXPECT_LE(result.outcomes.undecided, result.outcomes.total / 1000);  // between needles of noise
  return result.normals;
}

TEST(OffsetNormals, OfAFineSphereMeshAreRadialWithinADegree) {
  const Shape sphere = test::sphere(1, 5);  // 20480 faces
  for (const SampleSite site : {SampleSite::faces, SampleSite::vertices}) {
    const Samples samples = sample_shape(sphere, site);
    for (const double offset : {0.01, 0.03, 0.05}) {
      EXPECT_LT(errors_on_sphere(samples.points, normals_of(sphere, samples, offset)).maxCoeff(), 1) << offset;
    }
  }
}

TEST(OffsetNormals, DoNotDependOnTheOrientationOfFaces) {
  RandomNumbers random(1);
  const Shape mixed = flip_orientation(test::sphere(1, 5), 0.5, random);
  const Samples faces = sample_shape(mixed, SampleSite::faces);
  EXPECT_LT(errors_on_sphere(faces.points, normals_of(mixed, faces, 0.03)).maxCoeff(), 1);
  // At a vertex the offset surface is a patch of a ball: all directions between its faces' are as good.
  const Samples vertices = sample_shape(mixed, SampleSite::vertices);
  EXPECT_LT(errors_on_sphere(vertices.points, normals_of(mixed, vertices, 0.03)).maxCoeff(), 4);
}

TEST(OffsetNormals, OfADenseSphereCloudAreRadialWithinADegreeOnAverage) {
  // The icosphere's 10242 vertices, 0.011 of the diagonal apart.
  const Shape cloud{test::sphere(1, 5).vertices, {}};
  const Samples samples = sample_shape(cloud, SampleSite::vertices);
  for (const double offset : {0.03, 0.05}) {
    EXPECT_LT(errors_on_sphere(samples.points, normals_of(cloud, samples, offset)).mean(), 1) << offset;
  }
}

TEST(OffsetNormals, HaveHalfTheErrorOfMeshNormalsUnderStrongNoise) {
  // Edges are 0.011 of the diagonal long. At vertices, where the faces' normals average, it takes stronger noise; below
  // that the offset surface is no better (docs/notes/reproducing.md, Fig 5).
  for (const auto& [noise, site] :
       {std::pair(0.005, SampleSite::faces), {0.02, SampleSite::faces}, {0.02, SampleSite::vertices}}) {
    RandomNumbers random(1);
    const Shape noisy =
        vertex_noise(test::sphere(1, 5), {.amplitude = noise, .distribution = NoiseDistribution::uniform}, random);
    const Samples samples = sample_shape(noisy, site);
    const double averaged = errors_on_sphere(samples.points, samples.normals).mean();
    const double by_offset = errors_on_sphere(samples.points, normals_of(noisy, samples, 0.05)).mean();
    EXPECT_LT(by_offset, averaged / 2) << noise;
  }
}

TEST(OffsetNormals, AreZeroForSamplesOffTheSurface) {
  Shape sphere = test::sphere(1, 2);
  sphere.vertices.conservativeResize(sphere.vertices.rows() + 1, 3);
  sphere.vertices.bottomRows(1) << 0.5, 0, 0;
  const OffsetSdfResult result = offset_sdf(sphere, sample_shape(sphere, SampleSite::vertices), {.offset = 0.05});
  EXPECT_EQ(result.outcomes.missing, 1U);
  EXPECT_TRUE(result.normals.bottomRows(1).isZero(0));
}

TEST(OffsetNormals, RejectInvalidOffsets) {
  const Shape sphere = test::sphere(1, 1);
  EXPECT_THROW(offset_sdf(sphere, sample_shape(sphere, SampleSite::faces), {.offset = 0}), InputError);
}

}  // namespace
}  // namespace shapegauge

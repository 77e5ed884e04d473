// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <gtest/gtest.h>

#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/preparation/denoise.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/preparation/gap_size.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/preparation/tube_area.h"
#include "shapegauge/core/shape/connectivity.h"
#include "tests/support/doubled_shapes.h"
#include "tests/support/test_shapes.h"

// Duplicate triangles do not change the diagnostics of a shape.

namespace shapegauge {

namespace {

using test::for_each_variant_with_duplicates;

TEST(DoubledTriangles, AreIgnoredByMeshDiagnostics) {
  for_each_variant_with_duplicates(
      diagnose, [](const ShapeDiagnostics& expected, const test::ShapeWithDuplicates& doubled) {
        const ShapeDiagnostics found = diagnose(doubled.shape);
        EXPECT_EQ(found.triangles, doubled.triangles.size());
        EXPECT_EQ(found.duplicate_triangles, doubled.triangles.size() - expected.triangles);
        EXPECT_EQ(found.area, expected.area);
        EXPECT_EQ(found.components, expected.components);
        EXPECT_EQ(found.closed, expected.closed);
        EXPECT_EQ(found.edges, expected.edges);
        EXPECT_EQ(found.boundary_edges, expected.boundary_edges);
        EXPECT_EQ(found.boundary_length, expected.boundary_length);
        EXPECT_EQ(found.non_manifold_edges, expected.non_manifold_edges);
        EXPECT_EQ(found.inconsistent_edges, expected.inconsistent_edges);
        EXPECT_EQ(found.gap_size, expected.gap_size);
        EXPECT_EQ(found.noise_deviation, expected.noise_deviation);
      });
}

TEST(DoubledTriangles, DoNotChangeTheVolume) {
  for_each_variant_with_duplicates(signed_volume, [](double expected, const test::ShapeWithDuplicates& doubled) {
    EXPECT_EQ(signed_volume(doubled.shape), expected);
  });
}

TEST(DoubledTriangles, DoNotChangeClosedness) {
  const auto closedness = [](const Shape& shape) {
    return std::array{is_closed(shape), is_closed_and_oriented(shape)};
  };
  for_each_variant_with_duplicates(closedness,
                                   [&](const std::array<bool, 2>& expected, const test::ShapeWithDuplicates& doubled) {
                                     EXPECT_EQ(closedness(doubled.shape), expected);
                                   });
}

TEST(DoubledTriangles, DoNotChangeTheWidestGap) {
  const auto widest = [](const Shape& shape) { return gap_sizes(shape).widest; };
  for_each_variant_with_duplicates(widest, [&](double expected, const test::ShapeWithDuplicates& doubled) {
    EXPECT_EQ(widest(doubled.shape), expected);
  });
}

TEST(DoubledTriangles, DoNotChangeTheSurfaceAreaAndTubeArea) {
  const auto areas = [](const Shape& shape) { return std::array{positive_area(shape), tube_area(shape)}; };
  for_each_variant_with_duplicates(
      areas, [&](const std::array<double, 2>& expected, const test::ShapeWithDuplicates& doubled) {
        EXPECT_EQ(areas(doubled.shape), expected);
      });
}

TEST(DoubledTriangles, AreDenoisedLikeTheMeshWithoutDuplicates) {
  RandomNumbers random(1);
  const Shape noisy =
      vertex_noise(test::sphere(1, 4), {.amplitude = 0.03, .distribution = NoiseDistribution::gaussian}, random);
  const DenoisedShape expected = denoised(noisy);
  ASSERT_GT(expected.pass_band, 0);
  for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(noisy)) {
    SCOPED_TRACE(doubled.name);
    const DenoisedShape found = denoised(doubled.shape);
    EXPECT_EQ(found.noise.deviation, expected.noise.deviation);
    EXPECT_EQ(found.noise.edge_length, expected.noise.edge_length);
    EXPECT_EQ(found.noise.agreement, expected.noise.agreement);
    ASSERT_EQ(found.pass_band, expected.pass_band);
    EXPECT_TRUE(found.shape.vertices == expected.shape.vertices(doubled.vertices, Eigen::all));
  }
}

}  // namespace

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/support/doubled_shapes.h"
#include "tests/support/test_shapes.h"

// A shape with doubled triangles has the values of the shape without them, and doubles have those of their first.

namespace shapegauge {

namespace {

/// Original triangle or vertex of each triangle or vertex of the doubled shape.
const std::vector<std::int32_t>& origins(const test::ShapeWithDuplicates& doubled, SampleSite site) {
  return site == SampleSite::faces ? doubled.triangles : doubled.vertices;
}

void expect_same_bits(const Eigen::VectorXd& found, const Eigen::VectorXd& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (Eigen::Index i = 0; i < found.size(); ++i) {
    const bool same = found[i] == expected[i] || (std::isnan(found[i]) && std::isnan(expected[i]));
    ASSERT_TRUE(same) << i << ": " << found[i] << " instead of " << expected[i];
  }
}

constexpr std::array sites{SampleSite::faces, SampleSite::vertices};

class DoubledTriangles : public testing::TestWithParam<test::NamedShape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, DoubledTriangles, testing::ValuesIn(test::shapes_without_duplicates()));

TEST_P(DoubledTriangles, HaveTheSamplesOfTheFirstCopyButWithWeightZero) {
  const Shape& shape = GetParam().shape;
  for (const SampleSite site : sites) {
    const Samples expected = sample_shape(shape, site);
    for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(shape)) {
      SCOPED_TRACE(doubled.name);
      const Samples found = sample_shape(doubled.shape, site);
      EXPECT_TRUE(found.points == expected.points(origins(doubled, site), Eigen::all));
      EXPECT_TRUE(found.normals == expected.normals(origins(doubled, site), Eigen::all));
      // Each weight is found once, at the first sample of its position; the others are 0.
      std::vector<bool> seen(static_cast<std::size_t>(expected.weights.size()));
      for (Eigen::Index i = 0; i < found.weights.size(); ++i) {
        const auto origin = static_cast<std::size_t>(origins(doubled, site)[static_cast<std::size_t>(i)]);
        ASSERT_EQ(found.weights[i], seen[origin] ? 0 : expected.weights[static_cast<Eigen::Index>(origin)]) << i;
        seen[origin] = true;
      }
    }
  }
}

TEST_P(DoubledTriangles, DoNotChangeRandomSurfaceSamples) {
  const Samples expected = sample_surface(GetParam().shape, 300);
  for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(GetParam().shape)) {
    SCOPED_TRACE(doubled.name);
    const Samples found = sample_surface(doubled.shape, 300);
    EXPECT_TRUE(found.points == expected.points);
    EXPECT_TRUE(found.normals == expected.normals);
    EXPECT_TRUE(found.weights == expected.weights);
  }
}

TEST_P(DoubledTriangles, DoNotChangeTheAutomaticOffset) {
  const AutomaticOffset expected = automatic_offset(GetParam().shape);
  for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(GetParam().shape)) {
    SCOPED_TRACE(doubled.name);
    const AutomaticOffset found = automatic_offset(doubled.shape);
    EXPECT_EQ(found.offset, expected.offset);
    EXPECT_EQ(found.gap, expected.gap);
    EXPECT_EQ(found.noise, expected.noise);
  }
}

TEST_P(DoubledTriangles, DoNotChangeTheOffsetSdf) {
  const Shape& shape = GetParam().shape;
  for (const SampleSite site : sites) {
    const OffsetSdfResult expected = offset_sdf(shape, sample_shape(shape, site), {.offset = 0.02});
    for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(shape)) {
      SCOPED_TRACE(doubled.name);
      const OffsetSdfResult found = offset_sdf(doubled.shape, sample_shape(doubled.shape, site), {.offset = 0.02});
      expect_same_bits(found.values, expected.values(origins(doubled, site)));
      EXPECT_TRUE(found.normals == expected.normals(origins(doubled, site), Eigen::all));
      EXPECT_EQ(found.outcomes.missing, static_cast<std::size_t>(found.values.array().isNaN().count()));
      EXPECT_EQ(found.outcomes.total, static_cast<std::size_t>(found.values.size()));
    }
  }
  const OffsetSdfResult expected = offset_sdf(shape, sample_surface(shape, 200), {.offset = 0.02});
  for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(shape)) {
    SCOPED_TRACE(doubled.name);
    expect_same_bits(offset_sdf(doubled.shape, sample_surface(doubled.shape, 200), {.offset = 0.02}).values,
                     expected.values);
  }
}

TEST_P(DoubledTriangles, DoNotChangeTheConventionalSdf) {
  const Shape& shape = GetParam().shape;
  for (const SampleSite site : sites) {
    const ConeSdfResult expected = cone_sdf(shape, sample_shape(shape, site), {});
    for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(shape)) {
      SCOPED_TRACE(doubled.name);
      const ConeSdfResult found = cone_sdf(doubled.shape, sample_shape(doubled.shape, site), {});
      expect_same_bits(found.values, expected.values(origins(doubled, site)));
      EXPECT_EQ(found.missing, static_cast<std::size_t>(found.values.array().isNaN().count()));
    }
  }
  const ConeSdfResult expected = cone_sdf(shape, sample_surface(shape, 200), {});
  for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(shape)) {
    SCOPED_TRACE(doubled.name);
    expect_same_bits(cone_sdf(doubled.shape, sample_surface(doubled.shape, 200), {}).values, expected.values);
  }
}

TEST(OffsetSdfOfSomeVertices, IsUnchangedByDoubledTriangles) {
  const Shape torus = test::torus(1, 0.35, 16, 24);
  const Eigen::VectorXd expected =
      offset_sdf(torus, sample_shape(torus, SampleSite::vertices), {.offset = 0.02}).values.head(10);
  for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(torus)) {
    SCOPED_TRACE(doubled.name);
    Samples some = sample_shape(doubled.shape, SampleSite::vertices);
    some.points.conservativeResize(10, Eigen::NoChange);
    some.normals.conservativeResize(10, Eigen::NoChange);
    some.weights.conservativeResize(10);
    const OffsetSdfResult found = offset_sdf(doubled.shape, some, {.offset = 0.02});
    ASSERT_EQ(found.values.size(), 10);
    EXPECT_TRUE(found.values.isApprox(expected, 1e-3));
  }
}

TEST(ConeSdfWithCgal, IsUnchangedByDoubledTriangles) {
  const Shape torus = test::torus(1, 0.35, 8, 12);
  const ConeSdfOptions options{.engine = ConeSdfEngine::cgal, .rays = 9};
  const ConeSdfResult expected = cone_sdf(torus, sample_shape(torus, SampleSite::faces), options);
  for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(torus)) {
    SCOPED_TRACE(doubled.name);
    const ConeSdfResult found = cone_sdf(doubled.shape, sample_shape(doubled.shape, SampleSite::faces), options);
    expect_same_bits(found.values, expected.values(doubled.triangles));
  }
}

}  // namespace

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/retrieval/descriptors/d2.h"
#include "shapegauge/retrieval/descriptors/light_field.h"
#include "shapegauge/retrieval/descriptors/panorama.h"
#include "shapegauge/retrieval/descriptors/shape_dna.h"
#include "shapegauge/retrieval/descriptors/spherical_harmonics.h"
#include "tests/support/doubled_shapes.h"

// Duplicate triangles do not change descriptors.

namespace shapegauge {

namespace {

class DescriptorsOfDoubledTriangles : public testing::TestWithParam<test::NamedShape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, DescriptorsOfDoubledTriangles, testing::ValuesIn(test::shapes_without_duplicates()));

template <typename Describe>
void expect_same(const Shape& shape, Describe describe) {
  const Eigen::VectorXf expected = describe(shape);
  for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(shape)) {
    EXPECT_TRUE(describe(doubled.shape) == expected) << doubled.name;
  }
}

TEST_P(DescriptorsOfDoubledTriangles, MatchThoseOfTheMeshWithoutDuplicates) {
  expect_same(GetParam().shape, [](const Shape& shape) { return d2(shape, {.points = 100}); });
  expect_same(GetParam().shape, [](const Shape& shape) { return light_field(shape, {.pixels = 32}); });
  expect_same(GetParam().shape,
              [](const Shape& shape) { return spherical_harmonics(shape, {.shells = 6, .bandwidth = 5}); });
  expect_same(GetParam().shape, [](const Shape& shape) { return shape_dna(shape); });
  expect_same(GetParam().shape, [](const Shape& shape) { return panorama(shape); });
}

TEST_P(DescriptorsOfDoubledTriangles, SphericalHarmonicsOfVoxelsMatchTheMeshWithoutDuplicates) {
  expect_same(GetParam().shape, [](const Shape& shape) {
    return spherical_harmonics(shape, {.shells = 6, .bandwidth = 5, .voxels = true});
  });
}

}  // namespace

}  // namespace shapegauge

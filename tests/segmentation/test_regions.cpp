#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <set>
#include <vector>

#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/region_features.h"
#include "shapegauge/segmentation/region_merging.h"
#include "shapegauge/segmentation/regions.h"
#include "shapegauge/segmentation/surface_regions.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Regions in a row, each of one node, neighbours of the next.
Regions row_of(std::int32_t count) {
  Regions regions(count);
  for (std::int32_t i = 0; i < count; ++i) {
    RegionSum sum;
    sum.nodes = 1;
    sum.area = i + 1;
    regions.add(i, sum);
    if (i == 0) continue;
    regions.make_neighbours(i - 1, i);
    regions.add(i - 1, i, PairSum::border, 1 << i);
  }
  return regions;
}

TEST(Regions, MergingAddsUp) {
  Regions regions = row_of(4);
  regions.add(0, 2, PairSum::pairs, 5);
  regions.add(1, 1, PairSum::pairs, 3);
  regions.merge(1, 2);
  EXPECT_EQ(regions.size(), 3);
  EXPECT_EQ(regions.of(1).area, 2 + 3);
  EXPECT_EQ(regions.of(0, 1, PairSum::pairs), 5);
  EXPECT_EQ(regions.of(1, 1, PairSum::pairs), 6);  // once for each order
  EXPECT_EQ(regions.of(1, 3, PairSum::border), 8);
  EXPECT_EQ(regions.perimeter(1), 2 + 8);
  EXPECT_EQ(regions.neighbours(1), (std::set<std::int32_t>{0, 3}));
  EXPECT_EQ(regions.neighbours(3), (std::set<std::int32_t>{1}));
  EXPECT_EQ(regions.region_of(2), 1);
  regions.merge(0, 1);
  EXPECT_EQ(regions.region_of(2), 0);
  EXPECT_EQ(regions.of(0, 0, PairSum::pairs), 6 + 2 * 5);
  EXPECT_EQ(regions.perimeter(0), 8);
}

double area_affinity(const Regions& regions, std::int32_t a, std::int32_t b) {
  return 1 / (regions.of(a).area + regions.of(b).area);
}

TEST(RegionMerging, TakesTheHighestAffinityFirstAndAsksAnew) {
  Regions regions = row_of(5);  // areas 1 to 5
  merge_regions(regions, area_affinity, {.parts = 2});
  // 1 + 2 = 3, then 3 + 3 = 6, then 4 + 5 = 9 against 6 + 4 = 10.
  EXPECT_EQ(regions.merges(), (std::vector<std::pair<std::int32_t, std::int32_t>>{{0, 1}, {0, 2}, {3, 4}}));
}

TEST(RegionMerging, StopsBelowTheLeastAffinity) {
  Regions regions = row_of(5);
  merge_regions(regions, area_affinity, {.least_affinity = 1.0 / 6});
  EXPECT_EQ(regions.size(), 3);
}

TEST(RegionMerging, CannotMergeWhatDoesNotTouch) {
  Regions regions(3);
  regions.make_neighbours(0, 2);
  merge_regions(regions, [](const Regions&, std::int32_t, std::int32_t) { return 1.0; }, {.parts = 1});
  EXPECT_EQ(regions.size(), 2);
  EXPECT_EQ(regions.region_of(2), 0);
  EXPECT_EQ(regions.region_of(1), 1);
}

TEST(RegionFeatures, HaveNamesOfTheirOwn) {
  const auto& names = region_feature_names();
  EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
  EXPECT_FALSE(names.back().empty());
}

Regions regions_of(const Shape& shape, int count) {
  const ThickSurface surface = thick_surface(shape);
  return surface_regions(surface, patches(surface.graph, {.count = count}, patch_costs(surface)), 300);
}

TEST(RegionFeatures, AreTheSameForEitherOrder) {
  const Regions regions = regions_of(test::box({1, 2, 3}, 6), 12);
  for (const std::int32_t b : regions.neighbours(0)) EXPECT_EQ(features_of(regions, 0, b), features_of(regions, b, 0));
}

TEST(RegionFeatures, AreFiniteForRegionsOfWhichNothingIsKnown) {
  EXPECT_TRUE(features_of(Regions(2), 0, 1).allFinite());
}

TEST(SurfaceRegions, OfAConvexShapeSeeEachOtherInsideAndNotOutside) {
  const ThickSurface surface = thick_surface(test::box({4, 1, 1}, 8));
  std::vector<std::int32_t> halves;
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) halves.push_back(surface.graph.samples.points(i, 0) > 0);
  const Regions regions = surface_regions(surface, halves, 200);
  EXPECT_NEAR(regions.of(0).area, 0.5, 1e-9);
  EXPECT_EQ(regions.of(0, 1, PairSum::seen_shallow), regions.of(0, 1, PairSum::pairs));
  EXPECT_EQ(regions.of(0, 1, PairSum::seen_deep), regions.of(0, 1, PairSum::pairs));
  EXPECT_EQ(regions.of(0, 1, PairSum::seen_outside), 0);
  EXPECT_EQ(regions.of(0, 1, PairSum::concave), 0);
  EXPECT_NEAR(regions.of(0, 1, PairSum::border), 4 / std::sqrt(18.0), 1e-6);
  // What is opposite to a side is on the same half; only the ends, 2 of 18, face each other,
  // and the two orders share them.
  EXPECT_NEAR(regions.of(0, 1, PairSum::opposite), 1.0 / 18, 1e-6);
}

TEST(SurfaceRegions, OfAHookDoNotSeeEachOtherInside) {
  // A torus cut in four quarters: those across see each other through the hole, not through the tube.
  const ThickSurface surface = thick_surface(test::torus(4, 0.5, 24, 96));
  std::vector<std::int32_t> quarters;
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) {
    const auto place = surface.graph.samples.points.row(i);
    quarters.push_back((place.x() > 0 ? 0 : 1) + (place.y() > 0 ? 0 : 2));
  }
  const Regions regions = surface_regions(surface, quarters, 300);
  EXPECT_EQ(regions.of(0, 3, PairSum::seen_deep), 0);
  EXPECT_GT(regions.of(0, 3, PairSum::seen_outside), 0.01 * regions.of(0, 3, PairSum::pairs));
  EXPECT_GT(regions.of(0, 0, PairSum::seen_deep), 0.3 * regions.of(0, 0, PairSum::pairs));
}

TEST(SurfaceRegions, SharesAddUpToTheWhole) {
  const Regions regions = regions_of(test::capsule(1, 3, 24, 10), 10);
  double area = 0;
  double opposite = 0;
  for (std::int32_t a = 0; a < regions.initial_size(); ++a) {
    area += regions.of(a).area;
    EXPECT_NEAR(regions.of(a).histogram.sum(), regions.of(a).area, 1e-12);
    for (std::int32_t b = 0; b < regions.initial_size(); ++b) opposite += regions.of(a, b, PairSum::opposite);
  }
  EXPECT_NEAR(area, 1, 1e-9);
  EXPECT_NEAR(opposite, 1, 1e-9);  // every triangle has an opposite side
}

}  // namespace
}  // namespace shapegauge

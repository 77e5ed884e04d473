// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <gmock/gmock.h>
#include <utility>
#include <vector>

#include "shapegauge/segmentation/region_merging.h"
#include "tests/segmentation/hand_made_surface.h"

namespace shapegauge {
namespace {

using test::regions_in_a_row;

double area_affinity(const Regions& regions, std::int32_t a, std::int32_t b) {
  return 1 / (regions.of(a).area + regions.of(b).area);
}

TEST(RegionMerging, MergesThePairOfHighestCurrentAffinityFirst) {
  Regions regions = regions_in_a_row(5);  // areas 1 to 5
  merge_regions(regions, area_affinity, {.parts = 2});
  // 1 + 2 = 3, then 3 + 3 = 6, then 4 + 5 = 9 against 6 + 4 = 10.
  EXPECT_EQ(regions.merges(), (std::vector<std::pair<std::int32_t, std::int32_t>>{{0, 1}, {0, 2}, {3, 4}}));
}

TEST(RegionMerging, StopsIfAllAffinitiesAreBelowTheMinimum) {
  Regions regions = regions_in_a_row(5);
  merge_regions(regions, area_affinity, {.min_affinity = 1.0 / 6});
  EXPECT_EQ(regions.size(), 3);
}

TEST(RegionMerging, BreaksTiesOfAffinityByTheLowestIndex) {
  Regions regions = regions_in_a_row(5);
  merge_regions(regions, [](const Regions&, std::int32_t, std::int32_t) { return 1.0; }, {.parts = 2});
  EXPECT_THAT(regions.merges(), testing::ElementsAre(testing::Pair(0, 1), testing::Pair(0, 2), testing::Pair(0, 3)));
}

TEST(RegionMerging, MergesPairsFromAnAffinityOfOneHalfByDefault) {
  Regions regions = regions_in_a_row(3);
  merge_regions(regions, [](const Regions&, std::int32_t, std::int32_t) { return 0.5; }, {});
  EXPECT_EQ(regions.size(), 1) << "an affinity that is just enough";
  Regions separate = regions_in_a_row(3);
  merge_regions(separate, [](const Regions&, std::int32_t, std::int32_t) { return 0.499; }, {});
  EXPECT_EQ(separate.size(), 3);
}

TEST(RegionMerging, DoesNotMergeRegionsThatDoNotTouch) {
  Regions regions(3);
  regions.make_neighbours(0, 2);
  merge_regions(regions, [](const Regions&, std::int32_t, std::int32_t) { return 1.0; }, {.parts = 1});
  EXPECT_EQ(regions.size(), 2);
  EXPECT_EQ(regions.region_of(2), 0);
  EXPECT_EQ(regions.region_of(1), 1);
}

TEST(RegionMerging, UpdatesTheAffinitiesOfAMergedRegion) {
  // 1 and 2 merge first; merging the result with 0 no longer pays.
  const RegionAffinity affinity = [](const Regions& regions, std::int32_t a, std::int32_t b) {
    if (regions.of(a).nodes + regions.of(b).nodes > 2) return 0.1;
    return a == 1 && b == 2 ? 0.9 : 0.8;
  };
  Regions regions = regions_in_a_row(3);
  merge_regions(regions, affinity, {});
  EXPECT_EQ(regions.merges(), (std::vector<std::pair<std::int32_t, std::int32_t>>{{1, 2}}));
}

TEST(RegionMerging, RequestedNumberOfPartsOverridesTheMinimumAffinity) {
  Regions regions = regions_in_a_row(4);
  merge_regions(regions, [](const Regions&, std::int32_t, std::int32_t) { return 0.0; },
                {.min_affinity = 0.5, .parts = 2});
  EXPECT_EQ(regions.size(), 2);
}

}  // namespace
}  // namespace shapegauge

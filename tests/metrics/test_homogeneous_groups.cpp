// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <set>

#include "shapegauge/metrics/homogeneous_groups.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

std::vector<HomogeneousGroup> groups_of(const std::vector<double>& ranking, double critical) {
  return homogeneous_groups(ranking.size(),
                            [&](std::size_t i, std::size_t j) { return std::abs(ranking[i] - ranking[j]) > critical; });
}

TEST(HomogeneousGroups, AreMaximalRangesOfRanksWithoutASignificantDifference) {
  // 9 and 8 do not differ by more than 1.5, 9 and 7 do, 8 and 7 do not; 3 stands alone.
  EXPECT_THAT(groups_of({9, 8, 7, 3}, 1.5),
              ElementsAre(HomogeneousGroup{0, 1}, HomogeneousGroup{1, 2}, HomogeneousGroup{3, 3}));
  EXPECT_THAT(groups_of({9, 8, 7, 3}, 10), ElementsAre(HomogeneousGroup{0, 3}));
  EXPECT_THAT(groups_of({9, 8}, 0.5), ElementsAre(HomogeneousGroup{0, 0}, HomogeneousGroup{1, 1}));
  EXPECT_TRUE(groups_of({}, 1).empty());
}

RC_GTEST_PROP(HomogeneousGroups, ContainExactlyThePairsWithoutASignificantDifference, ()) {
  auto ranking = *rc::gen::container<std::vector<double>>(
      rc::gen::map(rc::gen::inRange(0, 30), [](int value) { return static_cast<double>(value); }));
  std::ranges::sort(ranking, std::greater<>());
  const double critical = *rc::gen::inRange(0, 12);
  const auto groups = groups_of(ranking, critical);
  for (std::size_t i = 0; i < ranking.size(); ++i) {
    for (std::size_t j = i; j < ranking.size(); ++j) {
      const bool together = std::ranges::any_of(
          groups, [&](const HomogeneousGroup& group) { return group.first <= i && j <= group.last; });
      RC_ASSERT(together == (ranking[i] - ranking[j] <= critical));
    }
  }
}

TEST(CompactLetters, AreSharedByMethodsWithoutASignificantDifference) {
  EXPECT_THAT(compact_letters(4, groups_of({9, 8, 7, 3}, 1.5)), ElementsAre("a", "ab", "b", "c"));
}

TEST(CompactLetters, AbbreviateMoreThanThreeGroupsAsARange) {
  // Each position is in the groups that begin at it and at the four before it.
  const std::vector<double> ranking{10, 9, 8, 7, 6, 5};
  EXPECT_THAT(compact_letters(6, groups_of(ranking, 3.5)), ElementsAre("a", "ab", "abc", "abc", "bc", "c"));
  const std::vector<double> longer{10, 9, 8, 7, 6, 5, 4, 3};
  EXPECT_EQ(compact_letters(8, groups_of(longer, 3.5))[3], "a-d");
}

TEST(CompactLetters, ContinueAfterTheLetterZ) {
  std::vector<double> ranking;
  for (int i = 0; i < 60; ++i) ranking.push_back(-i);
  const auto letters = compact_letters(60, groups_of(ranking, 0.5));
  EXPECT_EQ(letters[25], "z");
  EXPECT_EQ(letters[26], "aa");
  EXPECT_EQ(letters[53], "bb");
  EXPECT_EQ(std::set<std::string>(letters.begin(), letters.end()).size(), 60U);
}

}  // namespace

}  // namespace shapegauge

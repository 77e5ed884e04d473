// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/pages/leaderboard_page.h"
#include "tests/pages/sample_leaderboard.h"
#include "tests/support/page_text.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;
using testing::Not;

TEST(LeaderboardPage, EscapesMarkupInNames) {
  const std::string page = leaderboard_page(test_leaderboard::sample_leaderboard().page);
  EXPECT_EQ(test::occurrences(page, "</script>"), 3U) << "the library, the data, the scripts";
  EXPECT_EQ(test::occurrences(page, "</title>"), 1U);
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, Not(HasSubstr("{{")));
}

TEST(LeaderboardPage, ContainsTheStandingsOfEveryMethodAndMeasure) {
  const LeaderboardPage& sample = test_leaderboard::sample_leaderboard().page;
  const auto board = test::json_of_page(leaderboard_page(sample));
  ASSERT_EQ(board["methods"].size(), sample.entries.size());
  ASSERT_EQ(board["micro"].size(), sample.micro.size());
  const MethodStanding& third = sample.macro[2][3];
  EXPECT_EQ(board["macro"][2][3]["rank"], third.rank);
  EXPECT_EQ(board["macro"][2][3]["letters"], third.letters);
  EXPECT_NEAR(board["macro"][2][3]["interval"][1].get<double>(), third.interval->high, 1e-5);
  EXPECT_EQ(board["downloads"]["csv"], sample.csv);
  EXPECT_EQ(board["refused"][0][1], "row 3 </script> is NaN");
  EXPECT_EQ(board["methods"][0]["url"], sample.entries[0].url);
  EXPECT_EQ(board["methods"][1]["evaluations"][0]["per_class"].size(), 4U);
}

}  // namespace

}  // namespace shapegauge

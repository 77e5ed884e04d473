// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/leaderboard/leaderboard_tables.h"
#include "tests/experiments/leaderboard/small_board.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;

TEST(LeaderboardTables, ContainMicroAndMacroAveragesWithIntervalsAndSignificanceGroups) {
  const test_board::SmallBoard small;
  const Leaderboard board = small.judged();
  const TextTable table = leaderboard_csv_table(board);
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_EQ(table.header.size(), 6U + 4 * 6);
  EXPECT_EQ(table.rows[0][5], "micro");
  EXPECT_EQ(table.rows[1][5], "macro");
  EXPECT_EQ(table.rows[3][6], score_text(board.macro[0][1].average, csv_style));
  EXPECT_EQ(table.rows[2][7], score_text(board.micro[0][1].interval->low, csv_style));
  EXPECT_EQ(table.rows[2][9], board.micro[0][1].letters);
}

TEST(LeaderboardTables, JsonContainsFractionalScoresSettingsAndRejectedFiles) {
  const test_board::SmallBoard small;
  small.add("bad.csv", "0,1\n1,0\n");
  small.add("good.json", R"({"authors": "A"})");
  const JudgingOptions options = small.options();
  Leaderboard board = small.judged();
  board.macro[0][1].average = 0.125;  // the classes are of one size
  const auto json = leaderboard_json(board, options);
  EXPECT_EQ(json["submissions"][1]["macro"]["NN"]["average"], 0.125);
  EXPECT_EQ(json["submissions"][1]["micro"]["NN"]["average"], board.micro[0][1].average);
  EXPECT_DOUBLE_EQ(json["submissions"][0]["micro"]["mAP"]["average"], 1.0);
  EXPECT_EQ(json["submissions"][0]["authors"], "A");
  EXPECT_EQ(json["submissions"][1]["macro"]["NN"]["rank"], 2);
  EXPECT_EQ(json["refused"][0]["file"], "bad.csv");
  EXPECT_EQ(json["submissions"][1]["micro"]["FT"]["group"], "b");
  EXPECT_EQ(json["submissions"][1]["macro"]["FT"]["group"], "A");
  EXPECT_EQ(json["resamples"], 200);
  EXPECT_EQ(json["rank_by"], "mAP");
}

TEST(LeaderboardTables, WarnThatThreeClassesCannotSeparateTwoMethods) {
  const test_board::SmallBoard small;
  Leaderboard board = small.judged();
  const StandingOptions options = small.options().standings;
  // Twelve queries differ, but no p-value of three classes is below 2^-2.
  EXPECT_EQ(board.micro[1][1].letters, "b");
  EXPECT_EQ(board.macro[1][1].letters, "A");
  EXPECT_THAT(few_classes_warning(board, options), testing::Optional(HasSubstr("3 classes")));
  EXPECT_THAT(explain_significance(board, options), HasSubstr("below 0.25"));
  // Three methods can: 6^-2 is below 5 %.
  board.submissions.push_back(board.submissions.front());
  EXPECT_FALSE(few_classes_warning(board, options));
}

}  // namespace

}  // namespace shapegauge

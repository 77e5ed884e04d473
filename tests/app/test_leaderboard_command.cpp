// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"
#include "tests/experiments/leaderboard/small_board.h"

namespace shapegauge::test_command_line {

namespace {

using testing::HasSubstr;
using testing::Not;

std::string shell_word(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

std::string leaderboard(const test_board::SmallBoard& small, const std::string& more = "") {
  return "leaderboard " + shell_word(small.submissions()) + " --labels " + shell_word(small.labels()) + " " + more;
}

TEST(LeaderboardCommand, PrintsMethodsByRankAndWritesAnHtmlPage) {
  const test_board::SmallBoard small;
  const auto page = small.folder.path() / "page.html";
  const Outcome outcome = succeeded(run_executable(leaderboard(small, "-o " + shell_word(page) + " --title Contest")));
  EXPECT_LT(outcome.output.find("good"), outcome.output.find("poor"));
  EXPECT_THAT(test::text_of(page), HasSubstr("<title>Contest"));
  EXPECT_EQ(run_executable(leaderboard(small, "-o " + shell_word(page))).status, 2) << "the page exists";
  EXPECT_EQ(run_executable(leaderboard(small, "-o " + shell_word(page) + " --replace")).status, 0);
}

TEST(LeaderboardCommand, RanksValidSubmissionsAndReportsInvalidOnes) {
  const test_board::SmallBoard small;
  small.add("bad.csv", "0,1\n1,0\n");
  small.add("odd.npy", "no numbers");
  const Outcome outcome = run_executable(leaderboard(small));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("good"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("bad")));
  EXPECT_THAT(outcome.errors, testing::AllOf(HasSubstr("bad.csv"), HasSubstr("odd.npy")));
}

TEST(LeaderboardCommand, PrintsAWarningSharedBySubmissionsOnce) {
  const test_board::SmallBoard small;
  test::write_text(small.labels(),
                   "id,class\nm1,b\nm0,a\nm2,c\nm3,a\nm4,b\nm5,c\nm6,a\nm7,b\nm8,c\nm9,a\nm10,b\nm11,c\n");
  const Outcome outcome = run_executable(leaderboard(small));
  EXPECT_THAT(outcome.errors, HasSubstr("2 submissions"));
  EXPECT_EQ(outcome.errors.find("--order"), outcome.errors.rfind("--order"));
}

TEST(LeaderboardCommand, ScoresMissingQueriesAsZeroByDefault) {
  const test_board::SmallBoard small;
  small.add("short.lists", "m0 m3 m6\nm1 m4 m7\n");
  const std::string table = run_executable(leaderboard(small, "--format csv")).output;
  EXPECT_THAT(table, HasSubstr("short"));
  EXPECT_EQ(run_executable(leaderboard(small, "--format csv --missing-queries zero")).output, table);
  EXPECT_EQ(run_executable(leaderboard(small, "--format csv -c")).output, table);
}

TEST(LeaderboardCommand, RewritesOnlyChangedPagesOfAnExistingSite) {
  const test_board::SmallBoard small;
  const std::string arguments = leaderboard(small, "-o " + shell_word(small.folder.path() / "site"));
  EXPECT_EQ(run_executable(arguments).status, 0);
  small.add("third.csv", test_board::small_matrix(1));
  const Outcome outcome = succeeded(run_executable(arguments));
  EXPECT_THAT(outcome.errors, testing::AllOf(HasSubstr("1 pages"), HasSubstr("2 unchanged")));
}

TEST(LeaderboardCommand, ComparesMethodsOverSeveralDataSetsByMeanRank) {
  const test_board::SmallBoard small;
  const auto at = [&](const std::string& name) { return small.folder.path() / name; };
  for (const std::string set : {"s", "t"}) {
    test::write_text(at(set + "/labels.csv"), test_board::small_labels());
    for (const std::string method : {"good", "poor"}) {
      test::write_text(at(set + "/" + method + ".csv"), test_board::small_matrix(method == "good" ? 0 : 3));
    }
  }
  const std::string sets = "leaderboard " + shell_word(at("s")) + " " + shell_word(at("t"));
  const Outcome outcome = succeeded(run_executable(sets + " -o " + shell_word(at("site"))));
  EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("mean rank"), HasSubstr("Friedman's test: chi-squared 2.00")));
  EXPECT_TRUE(std::filesystem::exists(at("site/t/index.html")));
  EXPECT_THAT(run_executable(sets + " --format csv --rank-by NN").output, HasSubstr("psb,micro,NN,good,100.0000"));
  EXPECT_THAT(run_executable(sets + " --format json").output, HasSubstr("\"rank_interval\""));
  EXPECT_THAT(run_executable("leaderboard " + shell_word(at("s"))).output, testing::Not(HasSubstr("mean rank")));
  test::write_text(at("s/more.csv"), test_board::small_matrix(1));
  const Outcome lacking = run_executable(sets);
  EXPECT_EQ(lacking.status, 1);
  EXPECT_THAT(lacking.errors, testing::AllOf(HasSubstr("\"more\""), HasSubstr("data set t")));
  expect_error_lines({{sets + " " + shell_word(small.submissions()), "--labels"},
                      {sets + " " + shell_word(at("s")), "two data sets"}});
}

TEST(LeaderboardCommand, RejectsMissingLabelsUnknownMeasuresAndUnsuitableFolders) {
  const test_board::SmallBoard small;
  const std::string folder = shell_word(small.submissions());
  const std::string labels = " --labels " + shell_word(small.labels());
  expect_error_lines({
      {"leaderboard " + folder, "--labels"},
      {"leaderboard " + folder + labels + " --rank-by BEP", "BEP"},
      {"leaderboard " + folder + labels + " --missing-queries skip", "--missing-queries"},
      {"leaderboard " + folder + labels + " -o " + folder, "submissions"},
      {"leaderboard " + folder + labels + " -o " + shell_word(small.folder.path()), "not a leaderboard site"},
      {"leaderboard '" + small.folder.path().string() + "/absent'" + labels, "absent"},
  });
}

}  // namespace

}  // namespace shapegauge::test_command_line

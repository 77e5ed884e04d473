// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/leaderboard/leaderboard_tables.h"
#include "shapegauge/experiments/leaderboard/write_leaderboard.h"
#include "tests/experiments/leaderboard/small_board.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;

/// Board with a method "fair" of three repetitions, whose JSON file is for all of them.
struct RepeatedBoard : test_board::SmallBoard {
  RepeatedBoard() {
    for (int seed = 1; seed <= 3; ++seed) {
      add(fmt::format("fair.seed{}.csv", seed), test_board::small_matrix(0.8 + 0.4 * seed));
    }
    add("fair.json", R"({"name": "Fair", "authors": "F"})");
  }
};

/// Evaluation of one repetition alone.
Evaluation evaluation_of(const RepeatedBoard& small, int seed) {
  EvaluationFiles files = small.options().files;
  files.matrix = small.submissions() / fmt::format("fair.seed{}.csv", seed);
  return evaluate_files(files, {}).evaluation;
}

TEST(Repetitions, AreMergedIntoOneMethodWithMeanAndStandardDeviation) {
  const RepeatedBoard small;
  const Leaderboard board = small.judged();
  ASSERT_EQ(board.submissions.size(), 3U);
  EXPECT_TRUE(board.refused.empty());
  const EvaluatedSubmission& fair = board.submissions[1];
  EXPECT_EQ(fair.submission.name, "Fair");
  const std::vector<Evaluation> alone{evaluation_of(small, 1), evaluation_of(small, 2), evaluation_of(small, 3)};
  const Eigen::Vector3d scores(alone[0].micro[1], alone[1].micro[1], alone[2].micro[1]);
  ASSERT_GT(scores.maxCoeff(), scores.minCoeff());
  EXPECT_NEAR(board.micro[1][1].average, scores.mean(), 1e-12);
  EXPECT_NEAR(fair.evaluation.micro[1], scores.mean(), 1e-12);
  EXPECT_NEAR(fair.evaluation.per_query.col(1).mean(), scores.mean(), 1e-12);
  EXPECT_NEAR(fair.micro_deviation[1], std::sqrt((scores.array() - scores.mean()).square().sum() / 2), 1e-12);
  const auto expect_mean = [&](const auto& precision_of) {
    EXPECT_NEAR(precision_of(fair.evaluation),
                (precision_of(alone[0]) + precision_of(alone[1]) + precision_of(alone[2])) / 3, 1e-12);
  };
  expect_mean([](const Evaluation& one) { return one.macro_curve.precision.at(3); });
  expect_mean([](const Evaluation& one) { return one.class_curves.at(0).precision.at(3); });
  EXPECT_EQ(fair.repetitions.size(), 3U);
  EXPECT_EQ(board.submissions[0].micro_deviation.size(), 0);
}

TEST(Repetitions, ShowTheirStandardDeviationInTablesFilesAndPages) {
  const RepeatedBoard small;
  const Leaderboard board = small.judged();
  const std::string deviation = score_text(board.submissions[1].micro_deviation[1], {});
  EXPECT_THAT(leaderboard_table(board, {}).rows[1][3], HasSubstr(" ± " + deviation));
  EXPECT_THAT(leaderboard_table(board, {}).rows[0][3], testing::Not(HasSubstr("±")));
  const TextTable csv = leaderboard_csv_table(board);
  EXPECT_EQ(csv.header[15], "FT_deviation");
  EXPECT_EQ(csv.rows[0][15], "");
  EXPECT_EQ(csv.rows[2][15], score_text(board.submissions[1].micro_deviation[1], csv_style));
  const auto json = leaderboard_json(board, small.options())["submissions"][1];
  EXPECT_EQ(json["macro"]["FT"]["deviation"], board.submissions[1].macro_deviation[1]);
  EXPECT_EQ(json["repetitions"][2]["file"], "fair.seed3.csv");
  const std::filesystem::path site = small.folder.path() / "site";
  write_site(site, "Title", board, small.options());
  EXPECT_FALSE(std::filesystem::exists(site / "methods/Fair.html")) << "it is no single matrix";
  EXPECT_THAT(test::text_of(site / "index.html"), HasSubstr("\"deviations\":{\"micro\":[0."));
}

TEST(Repetitions, WithASingleFileAreAnOrdinarySubmission) {
  const test_board::SmallBoard small;
  small.add("alone.seed7.csv", test_board::small_matrix(0.5));
  const Leaderboard board = small.judged();
  ASSERT_EQ(board.submissions.size(), 3U);
  for (const EvaluatedSubmission& judged : board.submissions) EXPECT_EQ(judged.micro_deviation.size(), 0);
  std::vector<std::string> names;
  for (const EvaluatedSubmission& judged : board.submissions) names.push_back(judged.submission.name);
  EXPECT_THAT(names, testing::Contains("alone"));
}

}  // namespace

}  // namespace shapegauge

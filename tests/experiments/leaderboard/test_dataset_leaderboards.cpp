// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/leaderboard/dataset_leaderboards.h"
#include "shapegauge/experiments/leaderboard/write_leaderboard.h"
#include "tests/experiments/leaderboard/small_board.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using test_board::small_labels;
using test_board::small_matrix;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// Data sets "s", "t" and "u", each with the methods "good" and "poor".
class DatasetLeaderboardFolders : public test::FolderTest {
 protected:
  DatasetLeaderboardFolders() {
    for (const char* name : {"s", "t", "u"}) {
      add(fmt::format("{}/labels.csv", name), small_labels());
      add(fmt::format("{}/good.csv", name), small_matrix(0));
      add(fmt::format("{}/poor.csv", name), small_matrix(3));
    }
  }
  void add(const std::string& name, const std::string& text) const { test::write_text(at(name), text); }
  [[nodiscard]] std::vector<fs::path> all() const { return {at("s"), at("t"), at("u")}; }
  static JudgingOptions options() {
    JudgingOptions options;
    options.standings.resampling.resamples = 200;
    return options;
  }
  [[nodiscard]] DatasetLeaderboards judged() const {
    Cache none;
    return evaluate_datasets(find_submitted_datasets(all(), {}), options(), none);
  }
  [[nodiscard]] std::string refusal(const std::vector<fs::path>& folders) const {
    return test::input_error_of([&] { find_submitted_datasets(folders, {}); });
  }
};

TEST_F(DatasetLeaderboardFolders, AreReadWithTheLabelsTargetsAndIdsInEachFolder) {
  add("t/targets.csv", small_labels());
  add("t/ids.txt", "m0\n");
  const std::vector<SubmittedDataset> found =
      find_submitted_datasets(std::vector{at("s"), at("t") / ""}, {.matrix = {}, .level = 2});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, "s");
  EXPECT_EQ(found[0].files.labels, at("s/labels.csv"));
  EXPECT_TRUE(found[0].files.targets.empty());
  EXPECT_EQ(found[0].files.level, 2U);
  EXPECT_EQ(found[1].name, "t");
  EXPECT_EQ(found[1].files.targets.filename(), "targets.csv");
  EXPECT_EQ(found[1].files.ids.filename(), "ids.txt");
}

TEST_F(DatasetLeaderboardFolders, AreRejectedWithMissingOrAmbiguousLabelsAndDuplicateNames) {
  add("bare/good.csv", small_matrix(0));
  add("twice/labels.csv", small_labels());
  add("twice/labels.cla", "PSB 1\n0 0\n");
  add("judged/qrels.txt", "m0 0 m3 1\n");
  add("deep/s/labels.csv", small_labels());
  EXPECT_THAT(refusal({at("s"), at("bare")}), AllOf(HasSubstr("bare"), HasSubstr("`labels`")));
  EXPECT_THAT(refusal({at("s/good.csv")}), HasSubstr("not a folder"));
  EXPECT_THAT(refusal({at("absent")}), HasSubstr("absent"));
  EXPECT_THAT(refusal({at("twice")}), HasSubstr("labels.cla and labels.csv"));
  EXPECT_THAT(refusal({at("s"), at("judged")}), HasSubstr("one kind"));
  EXPECT_THAT(refusal({at("s"), at("deep/s")}), AllOf(HasSubstr("two data sets"), HasSubstr("\"s\"")));
}

TEST_F(DatasetLeaderboardFolders, RankMethodsByTheirMeanRankOverDataSets) {
  const DatasetLeaderboards all = judged();
  EXPECT_THAT(all.results.methods, ElementsAre("good", "poor"));
  const MultiDatasetTable& table = main_table(all.results);
  EXPECT_EQ(table.measure, "mAP");
  EXPECT_TRUE(table.values.col(0).isOnes(1e-12));
  EXPECT_DOUBLE_EQ(table.values(1, 1), all.boards[1].submissions[1].evaluation.micro[5]);
  EXPECT_EQ(table.ranks.mean_ranks, Eigen::Vector2d(1, 2));
  EXPECT_DOUBLE_EQ(table.ranks.friedman.chi_squared, 3);  // N (k - 1): all data sets agree
  EXPECT_THAT(table.rank_intervals, ElementsAre(RankInterval{1, 1}, RankInterval{2, 2}));
  EXPECT_EQ(table.deviations.size(), 0);
  EXPECT_TRUE(all.refused.empty());
}

TEST_F(DatasetLeaderboardFolders, ExcludeMethodsMissingInOneDataSet) {
  add("s/more.csv", small_matrix(1));
  add("u/more.csv", small_matrix(1));
  add("t/poor.csv", "0,1\n1,0\n");
  const DatasetLeaderboards all = judged();
  EXPECT_THAT(all.results.methods, ElementsAre("good"));
  ASSERT_EQ(all.refused.size(), 3U);
  EXPECT_EQ(all.refused[0].file, at("t/poor.csv"));
  EXPECT_THAT(all.refused[1].reason, AllOf(HasSubstr("\"more\""), HasSubstr("data set t")));
  EXPECT_THAT(all.refused[2].reason, AllOf(HasSubstr("\"poor\""), HasSubstr("data set t")));
  const auto json = dataset_leaderboards_json(all, options());
  EXPECT_EQ(json["refused"][1]["file"], "s/more.csv");
  EXPECT_EQ(json["refused"].dump().find(at("s").string()), std::string::npos);
}

TEST_F(DatasetLeaderboardFolders, AreRejectedWithoutACommonMethod) {
  fs::remove(at("t/good.csv"));
  fs::remove(at("u/poor.csv"));
  EXPECT_THAT(test::input_error_of([&] { (void)judged(); }), HasSubstr("no method"));
  add("u/good.csv", "0,1\n1,0\n");
  EXPECT_THAT(test::input_error_of([&] { (void)judged(); }), HasSubstr("data set u"));
}

TEST_F(DatasetLeaderboardFolders, ShowTheStandardDeviationOfRepeatedSubmissions) {
  for (const char* name : {"s", "t", "u"}) {
    for (int seed = 1; seed <= 2; ++seed) {
      add(fmt::format("{}/fair.seed{}.csv", name, seed), small_matrix(1 + 0.5 * seed));
    }
  }
  const DatasetLeaderboards all = judged();
  const MultiDatasetTable& table = main_table(all.results);
  ASSERT_EQ(table.deviations.rows(), 3);
  const TextTable summary = multi_dataset_summary(all.results, table);
  EXPECT_THAT(summary.header, ElementsAre("method", "s", "t", "u", "mean", "mean rank", "rank", "group"));
  EXPECT_EQ(summary.rows[0], (std::vector<std::string>{"good", "100.00", "100.00", "100.00", "100.00", "1.00", "1",
                                                       summary.rows[0][7]}));
  EXPECT_EQ(summary.rows[1][0], "fair");
  EXPECT_THAT(summary.rows[1][1], HasSubstr(" ± "));
  const TextTable csv = multi_dataset_csv_table(all.results);
  EXPECT_THAT(std::vector<std::string>(csv.header.end() - 3, csv.header.end()),
              ElementsAre("s_deviation", "t_deviation", "u_deviation"));
  for (const std::vector<std::string>& row : csv.rows) {
    EXPECT_EQ(row.back().empty(), row[3] != "fair") << row[3];
    EXPECT_THAT(row, testing::Each(testing::Not(HasSubstr("±"))));
  }
  const auto json = dataset_leaderboards_json(all, options())["tables"][5];
  EXPECT_EQ(json["measure"], "mAP");
  EXPECT_EQ(json["methods"][1]["deviations"]["t"], table.deviations(1, 1));
  EXPECT_EQ(json["methods"][1]["rank_interval"][0], 2);
}

TEST_F(DatasetLeaderboardFolders, WebSiteLinksToThePageOfEachDataSet) {
  const fs::path site = at("site");
  const DatasetLeaderboards all = judged();
  EXPECT_EQ(write_dataset_site(site, "Contest", all, options()).written, 6U);
  EXPECT_THAT(test::text_of(site / "index.html"), AllOf(HasSubstr("<title>Contest"), HasSubstr("t/index.html")));
  EXPECT_THAT(test::text_of(site / "t/index.html"), HasSubstr("<title>Contest: t"));
  EXPECT_THAT(test::text_of(site / "leaderboard.csv"), HasSubstr("psb,macro,mAP,good"));
  EXPECT_THAT(test::text_of(site / "index.html"), testing::Not(HasSubstr(at("s").string())));
  EXPECT_EQ(write_dataset_site(site, "Contest", all, options()).unchanged, 6U);
  EXPECT_THAT(dataset_leaderboards_html("Contest", all), testing::Not(HasSubstr("t/index.html")));
}

}  // namespace

}  // namespace shapegauge

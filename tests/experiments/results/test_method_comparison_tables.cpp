// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <map>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/results/method_comparison_tables.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::SizeIs;

/// Three methods under two measures, with invented, distinct numbers.
class ComparisonTables : public testing::Test {
 protected:
  static PairDifference pair(std::size_t first, std::size_t second, double difference, double p_holm) {
    return {.first = first,
            .second = second,
            .difference = difference,
            .interval = {.low = difference - 0.0625, .high = difference + 0.125},
            .p = p_holm / 2,
            .p_holm = p_holm,
            .p_tukey = p_holm / 4,
            .p_classes = 2 * p_holm,
            .effect_size = 10 * difference,
            .queries = {.wins = 5, .ties = 3, .losses = 1}};
  }

  ComparisonTables() {
    MethodComparison nn;
    nn.averages = Eigen::Vector3d(0.25, 0.75, 0.5);
    nn.intervals = {{0.2, 0.3}, {0.7, 0.8}, {0.4, 0.6}};
    nn.pairs = {pair(0, 1, -0.5, 0.01), pair(0, 2, -0.25, 0.06), pair(1, 2, 0.25, 0.04)};
    nn.units = 9;
    MethodComparison ft = nn;
    ft.averages = Eigen::Vector3d(0.9, 0.1, 0.3);
    ft.pairs = {pair(0, 1, 0.8, 0.00001), pair(0, 2, 0.6, 0.05), pair(1, 2, -0.2, 0.5)};
    comparisons = {nn, ft};
  }

  AlignedMethods methods{
      .methods = {"x", "y", "z"}, .protocol = "psb", .measures = {"NN", "FT"}, .classes = {0, 0, 1}, .values = {}};
  std::vector<MethodComparison> comparisons;
};

TEST_F(ComparisonTables, SummariseAveragesIntervalsAndSignificanceMarks) {
  const TextTable table = comparison_summary(methods, comparisons, {}, {.percent = true, .decimals = 1});
  EXPECT_THAT(table.header, ElementsAre("", "method", "NN", "FT"));
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre("a", "x", "25.0 [20.0, 30.0]", "90.0 [20.0, 30.0]"),
                                      ElementsAre("b", "y", "75.0 [70.0, 80.0]", "10.0 [70.0, 80.0]"),
                                      ElementsAre("c", "z", "50.0 [40.0, 60.0]", "30.0 [40.0, 60.0]")));
  std::map<std::pair<std::size_t, std::size_t>, std::string> marks;
  std::vector<std::pair<std::size_t, std::size_t>> bold;
  for (const Emphasis& emphasis : table.emphases) {
    if (!emphasis.mark.empty()) marks[{emphasis.row, emphasis.column}] = emphasis.mark;
    if (emphasis.bold) bold.emplace_back(emphasis.row, emphasis.column);
  }
  // NN: y is better than x and z, and z is not better than x (0.06). FT: x is better than y and z (just, at 0.05). In
  // other classes too: NN y than x (0.02), FT x than y.
  EXPECT_EQ(marks, (decltype(marks){{{1, 2}, "a*c"}, {{0, 3}, "b*c"}}));
  EXPECT_THAT(bold, testing::UnorderedElementsAre(testing::Pair(1, 2), testing::Pair(0, 3)));
}

TEST_F(ComparisonTables, MarkADifferenceWhosePValueEqualsTheSignificanceLevel) {
  const TextTable table = comparison_summary(methods, comparisons, {.confidence = 0.5}, {});
  // FT: z is better than y with a p of 0.5, which is what is left of a confidence of 0.5.
  EXPECT_TRUE(std::ranges::any_of(table.emphases, [](const Emphasis& emphasis) {
    return emphasis.row == 2 && emphasis.column == 3 && emphasis.mark == "b";
  }));
}

TEST_F(ComparisonTables, ListPairsOfMethodsForEachMeasure) {
  const TextTable table = pairs_table(methods, comparisons, {.percent = true, .decimals = 1}, false);
  EXPECT_THAT(table.header, ElementsAre("measure", "first", "second", "difference", "low", "high", "p", "p_holm",
                                        "p_tukey", "p_classes", "effect_size", "wins", "ties", "losses"));
  ASSERT_THAT(table.rows, SizeIs(6));
  EXPECT_THAT(table.rows[1], ElementsAre("NN", "x", "z", "-25.0", "-31.2", "-12.5", "0.0300", "0.0600", "0.0150",
                                         "0.1200", "-2.50", "5", "3", "1"));
  EXPECT_THAT(table.rows[3], ElementsAre("FT", "x", "y", "+80.0", "+73.8", "+92.5", "<0.0001", "<0.0001", "<0.0001",
                                         "<0.0001", "8.00", "5", "3", "1"));
  EXPECT_EQ(pairs_table(methods, comparisons, {}, true).rows[3][7], "1e-05");
}

TEST_F(ComparisonTables, NeverPrintNegativeZero) {
  PairDifference& pair = comparisons[0].pairs[0];
  pair.difference = -1e-17;
  pair.effect_size = -1e-9;
  const TextTable table = pairs_table(methods, comparisons, {}, false);
  EXPECT_EQ(table.rows[0][3], "+0.00");
  EXPECT_EQ(table.rows[0][10], "0.00");
}

TEST_F(ComparisonTables, JsonContainsFractionalScoresAndTestSettings) {
  const auto json = comparison_json(
      methods, comparisons,
      {.test = PairTest::t, .blocks = ResamplingUnit::queries, .average = Average::macro, .confidence = 0.9});
  EXPECT_EQ(json["protocol"], "psb");
  EXPECT_EQ(json["test"], "t");
  EXPECT_EQ(json["blocks"], "queries");
  EXPECT_EQ(json["average"], "macro");
  EXPECT_EQ(json["confidence"], 0.9);
  EXPECT_EQ(json["units"], 9);
  EXPECT_EQ(json["queries"], 3);
  EXPECT_EQ(json["measures"]["FT"]["methods"][2]["method"], "z");
  EXPECT_EQ(json["measures"]["FT"]["methods"][2]["average"], 0.3);
  EXPECT_EQ(json["measures"]["NN"]["methods"][1]["interval"][1], 0.8);
  const auto& pair = json["measures"]["NN"]["pairs"][2];
  EXPECT_EQ(pair["first"], "y");
  EXPECT_EQ(pair["second"], "z");
  EXPECT_EQ(pair["difference"], 0.25);
  EXPECT_EQ(pair["p"], 0.02);
  EXPECT_EQ(pair["p_holm"], 0.04);
  EXPECT_EQ(pair["p_tukey"], 0.01);
  EXPECT_EQ(pair["p_classes"], 0.08);
  EXPECT_EQ(pair["wins"], 5);
  EXPECT_EQ(pair["losses"], 1);
}

}  // namespace

}  // namespace shapegauge

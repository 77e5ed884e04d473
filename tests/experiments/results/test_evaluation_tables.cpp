// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/experiments/evaluation/method_scores.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::Each;
using testing::ElementsAre;
using testing::SizeIs;

/// Values on a line: three of class A, four of class B, and one that is alone in its class, in rows that are in no
/// order. No two distances of a row are equal. The scores are those of a script that knows the definitions only:
/// classes differ, queries differ, and so do micro and macro.
class EvaluationTables : public testing::Test {
 protected:
  EvaluationTables() {
    const Eigen::VectorXd at{{7.4, 0, 2, 5.7, 1.1, 3.6, 9.5, 4.3}};
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> distances(8, 8);
    for (int i = 0; i < 8; ++i) {
      for (int j = 0; j < 8; ++j) distances(i, j) = std::abs(at[i] - at[j]);
    }
    evaluation = evaluate(distances, labels, {});
    paper = evaluate(distances, labels, {.protocol = Protocol::paper});
  }

  std::vector<int> labels{2, 0, 2, 1, 0, 2, 2, 0};
  std::vector<std::string> classes{"A", "alone", "B"};
  std::vector<std::string> ids{"s", "t", "u", "v", "w", "x", "y", "z"};
  Evaluation evaluation;
  Evaluation paper;
  std::vector<NamedEvaluation> named{{.method = "m", .evaluation = &evaluation}};
};

// The precision of the curves at these levels, the 1st, 7th, 10th, 16th and last: over queries, over classes, A, B.
struct Level {
  std::size_t index;
  const char* recall;
  const char* micro;
  const char* macro;
  const char* a;
  const char* b;
};
const std::vector<Level> levels{{0, "0.05", "0.600000", "0.595833", "0.566667", "0.625000"},
                                {6, "0.35", "0.614583", "0.614583", "0.566667", "0.614583"},
                                {9, "0.5", "0.540476", "0.543750", "0.566667", "0.520833"},
                                {15, "0.8", "0.471837", "0.474524", "0.493333", "0.455714"},
                                {19, "1", "0.484354", "0.479365", "0.444444", "0.514286"}};

TEST_F(EvaluationTables, SummariseMicroAndMacroAverages) {
  const TextTable table = summary_table(named);
  EXPECT_THAT(table.header, ElementsAre("method", "protocol", "average", "NN", "FT", "ST", "E", "DCG", "mAP"));
  EXPECT_EQ(table.text_columns, 3U);
  EXPECT_THAT(table.rows,
              ElementsAre(ElementsAre("m", "psb", "micro", "28.57", "33.33", "76.19", "53.33", "67.16", "51.30"),
                          ElementsAre("m", "psb", "macro", "29.17", "33.33", "75.00", "52.22", "66.72", "51.21")));
}

TEST(MergeEqualAverages, MergesRowsOfEqualPrintedScores) {
  const TextTable table{.header = {"method", "average", "NN"},
                        .rows = {{"a", "micro", "50.00"},
                                 {"a", "macro", "50.00"},
                                 {"b", "micro", "60.00"},
                                 {"b", "macro", "60.01"},
                                 {"c", "micro", "60.00"},
                                 {"c", "macro", "60.00"}},
                        .text_columns = 2,
                        .emphases = {{.row = 1, .column = 2, .bold = true, .mark = {}},
                                     {.row = 4, .column = 2, .bold = true, .mark = {}}}};
  const TextTable merged = merge_equal_averages(table);
  EXPECT_THAT(merged.rows, ElementsAre(ElementsAre("a", "both", "50.00"), ElementsAre("b", "micro", "60.00"),
                                       ElementsAre("b", "macro", "60.01"), ElementsAre("c", "both", "60.00")));
  ASSERT_THAT(merged.emphases, SizeIs(1));
  EXPECT_EQ(merged.emphases[0].row, 3U);
}

TEST_F(EvaluationTables, PrintPercentOrFractionsWithTheRequestedDigits) {
  EXPECT_THAT(summary_table(named, {.percent = false, .decimals = 3}).rows[0],
              ElementsAre("m", "psb", "micro", "0.286", "0.333", "0.762", "0.533", "0.672", "0.513"));
}

TEST_F(EvaluationTables, ContainSeparateRowsForEachEvaluation) {
  named.push_back({.method = "n", .evaluation = &paper});
  const TextTable table = summary_table(named);
  ASSERT_THAT(table.rows, SizeIs(4));
  EXPECT_EQ(table.rows[1][2], "macro");
  EXPECT_THAT(std::vector(table.rows[2].begin(), table.rows[2].begin() + 4),
              ElementsAre("n", "paper", "micro", "28.57"));
  // A query that finds itself: the first tier is (1 + hits among the first R - 1) / R.
  EXPECT_NE(table.rows[2][4], table.rows[0][4]);
  EXPECT_THAT(per_query_table(named, ids, classes).rows, SizeIs(14));
  EXPECT_EQ(per_query_table(named, ids, classes).rows[7][1], "paper");
  EXPECT_THAT(per_class_table(named, classes).rows, SizeIs(4));
  EXPECT_THAT(precision_recall_table(named).rows, SizeIs(20 + 11));
  EXPECT_THAT(class_curves_table(named, classes).rows, SizeIs(2 * 20 + 2 * 11));
}

TEST_F(EvaluationTables, PrintIntervalsNextToScoresOrInColumns) {
  for (const double i : {0, 1, 2, 3, 4, 5}) {
    named[0].intervals.micro.push_back({.low = 0.01 * i, .high = 0.9 + 0.01 * i});
    named[0].intervals.macro.push_back({.low = 0.1 + 0.01 * i, .high = 0.8 + 0.01 * i});
  }
  const TextTable with_intervals = summary_table(named, {}, IntervalCells::in_cells);
  EXPECT_EQ(with_intervals.rows[0][3], "28.57 [0.00, 90.00]");
  EXPECT_EQ(with_intervals.rows[0][8], "51.30 [5.00, 95.00]");
  EXPECT_EQ(with_intervals.rows[1][4], "33.33 [11.00, 81.00]");
  const TextTable columns = summary_table(named, {}, IntervalCells::columns);
  ASSERT_THAT(columns.header, SizeIs(21));
  ASSERT_THAT(columns.rows, Each(SizeIs(21)));
  EXPECT_EQ(columns.header[9], "NN_low");
  EXPECT_EQ(columns.header[20], "mAP_high");
  EXPECT_EQ(columns.rows[0][12], "91.00");  // FT_high
  EXPECT_EQ(columns.rows[1][19], "15.00");  // mAP_low
  EXPECT_THAT(summary_table(named).header, SizeIs(9));
  const TextTable long_table = intervals_table(named);
  ASSERT_THAT(long_table.rows, SizeIs(12));
  EXPECT_THAT(long_table.rows[2], ElementsAre("m", "psb", "micro", "ST", "76.1905", "2.0000", "92.0000"));
  EXPECT_THAT(long_table.rows[9], ElementsAre("m", "psb", "macro", "E", "52.2222", "13.0000", "83.0000"));
  named[0].intervals = {};
  EXPECT_THAT(summary_table(named, {}, IntervalCells::columns).header, SizeIs(9));
  EXPECT_THAT(intervals_table(named).rows, SizeIs(0));
}

TEST_F(EvaluationTables, ConfidenceIntervalsContainTheirAverages) {
  const EvaluationIntervals over_queries = intervals_of(evaluation, {.blocks = ResamplingUnit::queries});
  const EvaluationIntervals over_classes = intervals_of(evaluation);
  for (Eigen::Index i = 0; i < 6; ++i) {
    const auto j = static_cast<std::size_t>(i);
    for (const EvaluationIntervals& intervals : {over_queries, over_classes}) {
      EXPECT_LE(intervals.micro[j].low, evaluation.micro[i] + 1e-12);
      EXPECT_GE(intervals.micro[j].high, evaluation.micro[i] - 1e-12);
      EXPECT_LE(intervals.macro[j].low, evaluation.macro[i] + 1e-12);
      EXPECT_GE(intervals.macro[j].high, evaluation.macro[i] - 1e-12);
    }
  }
  // Of seven queries none may be drawn that finds its class; of two classes the worse one finds it in a quarter.
  EXPECT_LT(over_queries.micro[0].low, 0.1);
  EXPECT_NEAR(over_classes.micro[0].low, 0.25, 1e-12);
}

TEST_F(EvaluationTables, ConfidenceIntervalsAreOmittedForOneClass) {
  EXPECT_THAT(intervals_of(evaluation).micro, SizeIs(6));
  const Evaluation one = evaluate(Eigen::MatrixXd::Ones(3, 3), std::vector<int>{0, 0, 0}, {});
  EXPECT_TRUE(intervals_of(one).micro.empty());
  EXPECT_THAT(intervals_of(one, {.confidence = 0.9, .blocks = ResamplingUnit::queries}).macro, SizeIs(6));
}

TEST_F(EvaluationTables, MarkTheBestScoreOfEachAverageInBold) {
  Evaluation worse = evaluation;
  worse.micro.setConstant(0.25);
  named.push_back({.method = "worse", .evaluation = &worse});
  std::map<std::size_t, int> bold;
  for (const Emphasis& emphasis : summary_table(named).emphases) ++bold[emphasis.row];
  // micro: the first method; macro: both are equal.
  EXPECT_EQ(bold, (std::map<std::size_t, int>{{0, 6}, {1, 6}, {3, 6}}));
}

TEST_F(EvaluationTables, PerClassTableOmitsClassesWithoutQueries) {
  const TextTable table = per_class_table(named, classes);
  EXPECT_THAT(table.header, ElementsAre("method", "protocol", "class", "queries", "NN", "FT", "ST", "E", "DCG", "mAP"));
  EXPECT_THAT(
      table.rows,
      ElementsAre(ElementsAre("m", "psb", "A", "3", "33.3333", "33.3333", "66.6667", "44.4444", "63.6255", "50.5556"),
                  ElementsAre("m", "psb", "B", "4", "25.0000", "33.3333", "83.3333", "60.0000", "69.8182", "51.8651")));
}

TEST_F(EvaluationTables, PerQueryTableHasIdsAndClasses) {
  const TextTable table = per_query_table(named, ids, classes, csv_style);
  ASSERT_THAT(table.rows, SizeIs(7));
  EXPECT_THAT(table.rows[0],
              ElementsAre("m", "psb", "s", "B", "0.0000", "33.3333", "100.0000", "60.0000", "73.3838", "53.3333"));
  EXPECT_THAT(table.rows[1],
              ElementsAre("m", "psb", "t", "A", "100.0000", "50.0000", "100.0000", "44.4444", "75.0000", "75.0000"));
  // v is alone in its class and therefore skipped: w follows u.
  EXPECT_THAT(table.rows[3],
              ElementsAre("m", "psb", "w", "A", "0.0000", "50.0000", "100.0000", "44.4444", "75.0000", "50.0000"));
  EXPECT_THAT(table.rows[6],
              ElementsAre("m", "psb", "z", "A", "0.0000", "0.0000", "0.0000", "44.4444", "40.8765", "26.6667"));
}

TEST_F(EvaluationTables, PerQueryScoresAreReadBackExactly) {
  EXPECT_EQ(per_query_table(named, ids, classes).rows[1][4], "100");
  EXPECT_EQ(per_query_table(named, ids, classes).rows[0][5], "33.33333333333333");
  RandomNumbers random(3);
  Eigen::MatrixXd& scores = evaluation.per_query;
  for (double& score : scores.reshaped())
    score = random.uniform(0, 1) * std::pow(10, -static_cast<int>(random.below(5)));
  scores.row(0) << 0, 1, 5e-324, 1e-17, 0.07, 0.57;
  const test::TemporaryFolder folder;
  test::write_text(folder.path() / "per_query.csv", to_csv(per_query_table(named, ids, classes)));
  EXPECT_EQ(read_method_scores(folder.path() / "per_query.csv").at(0).values, scores);
}

TEST(ScoreText, NeverPrintsNegativeZero) {
  for (const double tiny : {-1e-17, -0.0, 0.0, -4e-5}) EXPECT_EQ(score_text(tiny, {}), "0.00");
  EXPECT_EQ(score_text(-5.1e-5, {}), "-0.01");
  EXPECT_EQ(score_text(-0.004, {.percent = false, .decimals = 2}), "0.00");
  EXPECT_EQ(score_text(-0.004, {.percent = false, .decimals = 3}), "-0.004");
}

TEST_F(EvaluationTables, PrecisionRecallTableAveragesOverQueriesAndOverClasses) {
  const TextTable table = precision_recall_table(named);
  EXPECT_THAT(table.header, ElementsAre("method", "protocol", "recall", "precision", "macro_precision"));
  ASSERT_THAT(table.rows, SizeIs(20));
  for (const Level& level : levels) {
    EXPECT_THAT(table.rows[level.index], ElementsAre("m", "psb", level.recall, level.micro, level.macro));
  }
}

TEST_F(EvaluationTables, PrecisionRecallTableHasACurvePerClass) {
  const TextTable table = class_curves_table(named, classes);
  EXPECT_THAT(table.header, ElementsAre("method", "protocol", "class", "recall", "precision"));
  ASSERT_THAT(table.rows, SizeIs(40));
  for (const Level& level : levels) {
    EXPECT_THAT(table.rows[level.index], ElementsAre("m", "psb", "A", level.recall, level.a));
    EXPECT_THAT(table.rows[20 + level.index], ElementsAre("m", "psb", "B", level.recall, level.b));
  }
}

TEST_F(EvaluationTables, PsbPlotListsRecallAndPrecision) {
  const std::string plot = psb_plot(evaluation.micro_curve);
  EXPECT_THAT(plot, testing::StartsWith("0.050000\t0.600000\n0.100000\t0.600000\n"));
  EXPECT_THAT(plot, testing::EndsWith("0.950000\t0.481224\n1.000000\t0.484354\n"));
}

TEST_F(EvaluationTables, JsonContainsScoresAsFractions) {
  const auto json = evaluation_json(evaluation, classes);
  EXPECT_EQ(json["protocol"], "psb");
  EXPECT_EQ(json["ties"], "index");
  EXPECT_EQ(json["queries"], 7);
  EXPECT_EQ(json["queries_with_ties"], 0);
  EXPECT_EQ(json["models_never_queries"], 1);
  EXPECT_FALSE(json.contains("intervals"));
  EXPECT_DOUBLE_EQ(json["micro"]["NN"], 2.0 / 7);
  EXPECT_DOUBLE_EQ(json["macro"]["NN"], (1.0 / 3 + 1.0 / 4) / 2);
  EXPECT_DOUBLE_EQ(json["per_class"]["A"]["NN"], 1.0 / 3);
  EXPECT_DOUBLE_EQ(json["per_class"]["B"]["NN"], 1.0 / 4);
  EXPECT_DOUBLE_EQ(json["per_class"]["B"]["E"], 0.6);
  EXPECT_FALSE(json["per_class"].contains("alone"));
  const auto with_intervals =
      evaluation_json(evaluation, classes, {.micro = {6, {0.25, 0.5}}, .macro = {6, {0.125, 0.75}}});
  EXPECT_EQ(with_intervals["intervals"]["micro"]["ST"][0], 0.25);
  EXPECT_EQ(with_intervals["intervals"]["micro"]["ST"][1], 0.5);
  EXPECT_EQ(with_intervals["intervals"]["macro"]["mAP"][1], 0.75);
}

}  // namespace

}  // namespace shapegauge

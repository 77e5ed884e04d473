#include <gmock/gmock.h>

#include "shapegauge/experiments/results/evaluation_tables.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

/// Two classes of two models and one of a single model, under psb: values on a line at 0, 1, 10, 11 and 5.
class Evaluations : public testing::Test {
 protected:
  Evaluations() {
    const Eigen::VectorXd at{{0, 1, 10, 11, 5}};
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> distances(5, 5);
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < 5; ++j) distances(i, j) = std::abs(at[i] - at[j]);
    }
    evaluation = evaluate(distances, labels, {});
  }

  std::vector<int> labels{0, 0, 1, 1, 2};
  std::vector<std::string> classes{"low", "high", "alone"};
  std::vector<std::string> ids{"0", "1", "2", "3", "4"};
  Evaluation evaluation;
  std::vector<NamedEvaluation> named{{.method = "m", .evaluation = &evaluation}};
};

TEST_F(Evaluations, Summary) {
  const Table table = summary_table(named);
  EXPECT_THAT(table.header, ElementsAre("method", "protocol", "average", "NN", "FT", "ST", "E", "DCG", "mAP"));
  ASSERT_EQ(table.rows.size(), 2U);
  // E of a perfect list: k = min(32, 4) results, 1 relevant: 2 / (4 + 1).
  EXPECT_THAT(table.rows[0],
              ElementsAre("m", "psb", "micro", "100.00", "100.00", "100.00", "40.00", "100.00", "100.00"));
  EXPECT_EQ(table.rows[1][2], "macro");
}

TEST_F(Evaluations, FractionsAndDigitsAsAsked) {
  EXPECT_EQ(summary_table(named, {.percent = false, .decimals = 3}).rows[0][6], "0.400");
}

TEST_F(Evaluations, IntervalsBesideTheFiguresOrInColumnsOfTheirOwn) {
  named[0].intervals.micro = std::vector<ConfidenceInterval>(6, {0.25, 1});
  named[0].intervals.macro = std::vector<ConfidenceInterval>(6, {0.5, 1});
  EXPECT_EQ(summary_table(named, {}, IntervalCells::beside).rows[0][3], "100.00 [25.00, 100.00]");
  const Table columns = summary_table(named, {}, IntervalCells::columns);
  ASSERT_EQ(columns.header.size(), 21U);
  EXPECT_EQ(columns.header[9], "NN_low");
  EXPECT_EQ(columns.header[20], "mAP_high");
  EXPECT_EQ(columns.rows[1][9], "50.00");
  EXPECT_EQ(summary_table(named).header.size(), 9U);
  const Table long_table = intervals_table(named);
  ASSERT_EQ(long_table.rows.size(), 12U);
  EXPECT_THAT(long_table.rows[9], ElementsAre("m", "psb", "macro", "E", "40.0000", "50.0000", "100.0000"));
  named[0].intervals = {};
  EXPECT_EQ(summary_table(named, {}, IntervalCells::columns).header.size(), 9U);
}

TEST_F(Evaluations, IntervalsNeedTwoClasses) {
  EXPECT_EQ(intervals_of(evaluation).micro.size(), 6U);
  const Evaluation one = evaluate(Eigen::MatrixXd::Ones(3, 3), std::vector<int>{0, 0, 0}, {});
  EXPECT_TRUE(intervals_of(one).micro.empty());
  EXPECT_EQ(intervals_of(one, {.confidence = 0.9, .blocks = Blocks::queries}).macro.size(), 6U);
}

TEST_F(Evaluations, TheBestOfAnAverageIsBold) {
  Evaluation worse = evaluation;
  worse.micro.setConstant(0.25);
  named.push_back({.method = "worse", .evaluation = &worse});
  const Table table = summary_table(named);
  for (const Emphasis& emphasis : table.emphases) EXPECT_NE(emphasis.row, 2U);
  EXPECT_EQ(table.emphases.size(), 6U + 12U);  // micro: the first method; macro: both are equal
}

TEST_F(Evaluations, CurvesOfClassesAndAPlot) {
  const Table table = class_curves_table(named, classes);
  ASSERT_EQ(table.rows.size(), 40U);
  EXPECT_THAT(table.rows[20], ElementsAre("m", "psb", "high", "0.05", "1.000000"));
  EXPECT_THAT(psb_plot(evaluation.micro_curve), testing::StartsWith("0.050000\t1.000000\n0.100000\t1.000000\n"));
}

TEST_F(Evaluations, PerClassLeavesOutClassesWithoutQueries) {
  const Table table = per_class_table(named, classes);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_THAT(table.rows[1], ElementsAre("m", "psb", "high", "2", "100.0000", "100.0000", "100.0000", "40.0000",
                                         "100.0000", "100.0000"));
}

TEST_F(Evaluations, PerQueryHasIdsAndClasses) {
  const Table table = per_query_table(named, ids, classes);
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_EQ(table.rows[3][2], "3");
  EXPECT_EQ(table.rows[3][3], "high");
}

TEST_F(Evaluations, PrecisionRecall) {
  const Table table = precision_recall_table(named);
  ASSERT_EQ(table.rows.size(), 20U);
  EXPECT_THAT(table.rows.front(), ElementsAre("m", "psb", "0.05", "1.000000", "1.000000"));
  EXPECT_THAT(table.rows.back(), ElementsAre("m", "psb", "1", "1.000000", "1.000000"));
}

TEST_F(Evaluations, AsJsonInFractions) {
  const auto json = evaluation_json(evaluation, classes);
  EXPECT_EQ(json["protocol"], "psb");
  EXPECT_EQ(json["ties"], "index");
  EXPECT_EQ(json["queries"], 4);
  EXPECT_EQ(json["queries_with_ties"], 0);
  EXPECT_FALSE(json.contains("intervals"));
  EXPECT_EQ(json["models_never_queries"], 1);
  EXPECT_EQ(json["micro"]["NN"], 1.0);
  EXPECT_DOUBLE_EQ(json["macro"]["E"], 0.4);
  EXPECT_DOUBLE_EQ(json["per_class"]["high"]["E"], 0.4);
  EXPECT_FALSE(json["per_class"].contains("alone"));
}

}  // namespace

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/metrics/precision_recall.h"
#include "tests/metrics/list_of_hits.h"

namespace shapegauge {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

constexpr double curve_rounding = 1e-15;

TEST(RecallLevels, AreTwentyForPsbCurvesAndElevenForPaperCurves) {
  const auto psb = recall_levels(CurveKind::psb);
  ASSERT_EQ(psb.size(), 20U);
  EXPECT_EQ(psb.front(), 0.05);
  EXPECT_EQ(psb[2], 0.15);
  EXPECT_EQ(psb.back(), 1.0);
  EXPECT_THAT(recall_levels(CurveKind::paper), ElementsAre(0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0));
}

// The example of psbPlot's documentation: a class of six, hits at ranks 1, 4, 10, 41, 44.
RankedList psb_plot_example() {
  std::vector<bool> hits(60, false);
  for (const std::size_t rank : {1, 4, 10, 41, 44}) hits[rank - 1] = true;
  return list_of_hits(hits);
}

TEST(PrecisionAtRecallLevels, PsbCurveInterpolatesLinearlyBetweenHits) {
  const Eigen::VectorXd precision = precision_at_levels(psb_plot_example(), CurveKind::psb);
  const auto at_recall = [&](int percent) { return precision[percent / 5 - 1]; };
  EXPECT_NEAR(at_recall(20), 1, curve_rounding);
  EXPECT_NEAR(at_recall(40), 0.5, curve_rounding);
  EXPECT_NEAR(at_recall(60), 0.3, curve_rounding);
  EXPECT_NEAR(at_recall(80), 4.0 / 41, curve_rounding);
  EXPECT_NEAR(at_recall(100), 5.0 / 44, curve_rounding);
  EXPECT_NEAR(at_recall(30), 0.75, curve_rounding);
  EXPECT_NEAR(at_recall(25), 0.875, curve_rounding);
  EXPECT_NEAR(at_recall(95), 0.25 * 4 / 41 + 0.75 * 5 / 44, curve_rounding);
}

TEST(PrecisionAtRecallLevels, PsbCurveUsesThePrecisionOfTheFirstHitBelowItsRecall) {
  const RankedList list = list_of_hits({false, true, true});
  const Eigen::VectorXd precision = precision_at_levels(list, CurveKind::psb);
  for (int level = 0; level < 10; ++level) EXPECT_EQ(precision[level], 0.5);
  EXPECT_GT(precision[10], 0.5);
}

TEST(PrecisionAtRecallLevels, CurveOfTheSdfPaperUsesThePrecisionOfTheLastHitUpToTheLevel) {
  // Hits at ranks 1, 2, 4, 8: recall 0.25, 0.5, 0.75, 1; precision 1, 1, 3/4, 1/2.
  const RankedList list = list_of_hits({true, true, false, true, false, false, false, true, false}, true);
  const Eigen::VectorXd precision = precision_at_levels(list, CurveKind::paper);
  const std::vector<double> values(precision.begin(), precision.end());
  EXPECT_THAT(values, ElementsAre(1, 1, 1, 1, 1, 1, 1, 1, 0.75, 0.75, 0.5));
}

TEST(PrecisionAtRecallLevels, PaperCurveIsOneBelowTheRecallOfTheFirstHit) {
  const Eigen::VectorXd precision = precision_at_levels(list_of_hits({false, true, true}), CurveKind::paper);
  const std::vector<double> values(precision.begin(), precision.end());
  EXPECT_THAT(values, ElementsAre(1, 1, 1, 1, 1, 0.5, 0.5, 0.5, 0.5, 0.5, 2.0 / 3));
}

TEST(PrecisionAtRecallLevels, PaperCurveIncludesAHitExactlyAtTheLevel) {
  // Ten relevant models: 0.1 * 3 is not the number nearest to 3 / 10, and the third hit must still count at level
  // 0.3.
  std::vector<bool> hits_at(100, false);
  for (std::size_t hit = 0; hit < 10; ++hit) hits_at[hit * hit] = true;
  const Eigen::VectorXd precision = precision_at_levels(list_of_hits(hits_at, true), CurveKind::paper);
  for (int hits = 1; hits <= 10; ++hits) {
    EXPECT_THAT(precision[hits], DoubleNear(static_cast<double>(hits) / ((hits - 1) * (hits - 1) + 1), curve_rounding));
  }
}

TEST(PrecisionAtRecallLevels, TrecCurveIsTheMaximumPrecisionAtThisOrAnyHigherRecall) {
  // Precision 1/2, 2/3, 3/6 at recall 1/3, 2/3, 1.
  const RankedList list = list_of_hits({false, true, true, false, false, true});
  const Eigen::VectorXd precision = precision_at_levels(list, CurveKind::trec);
  ASSERT_EQ(precision.size(), 11);
  for (int level = 0; level <= 10; ++level) EXPECT_EQ(precision[level], level <= 6 ? 2.0 / 3 : 0.5) << level;
}

TEST(PrecisionAtRecallLevels, RawCurveIsThePrecisionOfTheFirstHitThatReachesTheLevel) {
  const RankedList list = list_of_hits({true, false, false, true});
  const Eigen::VectorXd longest = precision_at_levels(list, CurveKind::raw, 2);
  EXPECT_THAT(std::vector<double>(longest.begin(), longest.end()), ElementsAre(1, 0.5));
  const Eigen::VectorXd shorter = precision_at_levels(list, CurveKind::raw, 5);
  EXPECT_THAT(std::vector<double>(shorter.begin(), shorter.end()), ElementsAre(1, 1, 0.5, 0.5, 0.5));
}

TEST(PrecisionAtRecallLevels, IsZeroBeyondTheRecallOfATruncatedList) {
  const Eigen::VectorXd precision = precision_at_levels(list_of_hits({true, false}, false, 1), CurveKind::trec);
  for (int level = 0; level <= 10; ++level) EXPECT_EQ(precision[level], level <= 5 ? 1 : 0) << level;
}

TEST(PrecisionRecallCurveKind, ConvertsToAndFromNamesAndFollowsTheProtocolByDefault) {
  EXPECT_THAT(list_of_words<CurveKind>(), ElementsAre("psb", "paper", "trec", "raw", "trec_eval"));
  for (const std::string& name : list_of_words<CurveKind>())
    EXPECT_EQ(name_of(value_of_word<CurveKind>(name).value()), name);
  EXPECT_FALSE(value_of_word<CurveKind>("smooth"));
  for (const std::string& name : list_of_words<Protocol>()) {
    EXPECT_EQ(name_of(default_curve(value_of_word<Protocol>(name).value())), name);
  }
}

TEST(AveragePrecisionRecallCurve, PsbCurveExcludesListsWithoutAHitBelowTheLevel) {
  Eigen::MatrixXd precisions(2, 20);
  precisions.row(0).setConstant(0.2);
  precisions.row(1).setConstant(0.6);
  const std::vector<std::size_t> relevant = {20, 4};
  const PrecisionRecallCurve curve = average_curve(precisions, relevant, CurveKind::psb);
  EXPECT_EQ(curve.recall, recall_levels(CurveKind::psb));
  for (std::size_t level = 0; level < 20; ++level) {
    // The second list has its first hit at recall 0.25, the level of index 4.
    EXPECT_NEAR(curve.precision[level], level < 4 ? 0.2 : 0.4, curve_rounding) << level;
  }
}

TEST(AveragePrecisionRecallCurve, PsbCurveUsesAllListsIfNoneHasAHitBelowTheLevel) {
  Eigen::MatrixXd precisions(2, 20);
  precisions.row(0).setConstant(0.5);
  precisions.row(1).setConstant(0.25);
  const std::vector<std::size_t> relevant = {19, 19};
  EXPECT_EQ(average_curve(precisions, relevant, CurveKind::psb).precision[0], 0.375);
}

TEST(AveragePrecisionRecallCurve, PaperCurveAveragesAllQueriesAtEachLevel) {
  Eigen::MatrixXd precisions(2, 11);
  precisions.row(0).setConstant(0.5);
  precisions.row(1).setConstant(0.25);
  const std::vector<std::size_t> relevant = {20, 2};
  for (const double precision : average_curve(precisions, relevant, CurveKind::paper).precision) {
    EXPECT_EQ(precision, 0.375);
  }
}

}  // namespace
}  // namespace shapegauge

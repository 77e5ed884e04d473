// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/evaluators.h"
#include "tests/metrics/list_of_hits.h"

namespace shapegauge {

namespace {

double score(std::string_view evaluator, std::string_view measure, const RankedList& list) {
  for (const Measure& one : options_of_evaluator(evaluator).measures) {
    if (one.name == measure) return one.value(list);
  }
  ADD_FAILURE() << evaluator << " has no " << measure;
  return 0;
}

TEST(EvaluationPrograms, TiersOfShrec21CountOneHitTooMany) {
  const RankedList perfect = list_of_hits({true, true, false, false});
  EXPECT_DOUBLE_EQ(score("shrec21", "shrec21.FT", perfect), 3.0 / 2);
  EXPECT_DOUBLE_EQ(score("shrec21", "shrec21.ST", perfect), 1) << "all are before rank 4";
  const RankedList late = list_of_hits({false, true, false, true, false});
  EXPECT_DOUBLE_EQ(score("shrec21", "shrec21.FT", late), (1.0 + 1) / 2);
  EXPECT_DOUBLE_EQ(score("shrec21", "shrec21.ST", late), (2.0 + 1) / 4) << "the last is at rank 4";
  const RankedList later = list_of_hits({false, false, false, true, true});
  EXPECT_DOUBLE_EQ(score("shrec21", "shrec21.FT", later), (0.0 + 1) / 2);
  EXPECT_DOUBLE_EQ(score("shrec21", "shrec21.ST", later), (1.0 + 1) / 4);
}

TEST(EvaluationPrograms, Shapenet16DividesAveragePrecisionByTheNumberOfHitsFound) {
  // Two of five relevant models, at ranks 1 and 3.
  const RankedList list =
      list_of_runs({{.size = 1, .hits = 1}, {.size = 1, .hits = 0}, {.size = 1, .hits = 1}}, false, 3);
  EXPECT_DOUBLE_EQ(score("shapenet16", "shapenet16.mAP", list), (1 + 2.0 / 3) / 2);
  EXPECT_DOUBLE_EQ(score("shapenet16", "shapenet16.nDCG", list), (1 + 1 / std::log2(3)) / (1 + 1));
  EXPECT_DOUBLE_EQ(score("shapenet16", "P@N", list), 2.0 / 3);
}

TEST(EvaluationPrograms, PytorchMetricLearningIgnoresHitsBeyondTheNumberOfRelevantModels) {
  const RankedList list = list_of_hits({false, true, true});
  EXPECT_DOUBLE_EQ(score("pytorch_metric_learning", "pytorch_metric_learning.MAP@R", list), (1.0 / 2) / 2);
  EXPECT_DOUBLE_EQ(score("pytorch_metric_learning", "mAP", list), (1.0 / 2 + 2.0 / 3) / 2);
  EXPECT_DOUBLE_EQ(score("pytorch_metric_learning", "R-prec", list), 0.5);
}

// 0.8 * 3 is nearer to two hits than to three.
TEST(EvaluationPrograms, TrecEvalRoundsRecallLevelsToWholeHits) {
  std::vector<bool> hits(10, false);
  hits[0] = hits[1] = hits[9] = true;
  const RankedList list = list_of_hits(hits);
  EXPECT_DOUBLE_EQ(precision_at_levels(list, CurveKind::trec, 3)[8], 0.3);
  EXPECT_DOUBLE_EQ(precision_at_levels(list, CurveKind::trec_eval, 3)[8], 1);
  EXPECT_DOUBLE_EQ(precision_at_levels(list, CurveKind::trec_eval, 3)[9], 0.3);
}

TEST(EvaluationPrograms, SelectProtocolMinimumClassSizeAndMeasuresByName) {
  EXPECT_EQ(options_of_evaluator("psb_table").minimum_class_size, 3);
  EXPECT_TRUE(options_of_evaluator("shapenet16").finds_itself);
  EXPECT_EQ(options_of_evaluator("trec_eval").protocol, Protocol::trec);
  for (const std::string& name : evaluator_names()) EXPECT_FALSE(options_of_evaluator(name).measures.empty()) << name;
  EXPECT_THROW(options_of_evaluator("psbtable"), ArgumentError);
}

}  // namespace

}  // namespace shapegauge

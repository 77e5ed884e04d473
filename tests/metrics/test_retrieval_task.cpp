// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/metrics/chance.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/retrieval_task.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

TEST(RetrievalTask, OfLeaveOneOutCountsOtherModelsOfTheClassAsRelevant) {
  const RetrievalTask task = leave_one_out(std::vector<int>{3, 5, 3, 3});
  EXPECT_THAT(relevant_counts(task), ElementsAre(2, 0, 2, 2));
  EXPECT_TRUE(Relevance(task).is_relevant(0, 2));
  EXPECT_FALSE(Relevance(task).is_relevant(0, 1));
}

TEST(RetrievalTask, CountsTheWholeClassAsRelevantIfQueriesAreNotTargets) {
  RetrievalTask task;
  task.query_classes = {3, no_class, 5};
  task.target_classes = {3, 3, no_class, 5};
  task.own_column = {-1, -1, 3};
  EXPECT_THAT(relevant_counts(task), ElementsAre(2, 0, 0));
}

TEST(RetrievalTask, ExcludesTheQueryFromItsJudgedRelevantModels) {
  RetrievalTask task = leave_one_out(std::vector<int>{0, 1, 2});
  task.judged = {{0, 2}, {0, 2}, {}};
  EXPECT_THAT(relevant_counts(task), ElementsAre(1, 2, 0));
  EXPECT_TRUE(Relevance(task).is_relevant(1, 2));
}

TEST(NearestNeighbourByChance, IsTheFractionOfRelevantModelsAmongOtherTargets) {
  RetrievalTask task;
  task.query_classes = {3, 5};
  task.target_classes = {3, 3, 5, 5, no_class};
  task.own_column = {-1, 2};
  const Evaluation evaluation = evaluate(DistanceMatrix::Zero(2, 5), task, {});
  EXPECT_DOUBLE_EQ(compare_nearest_with_chance(evaluation, task)->expected, (2.0 / 4 + 1.0 / 3) / 2);
}

}  // namespace

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

#include "shapegauge/metrics/equal_scores.h"
#include "shapegauge/metrics/friedman_test.h"
#include "shapegauge/metrics/method_comparison.h"
#include "shapegauge/metrics/method_standings.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

constexpr int query_count = 18;

// Queries x methods; every method finds 7 of 18 queries, each other ones. Three classes have 6, 6 and 6 queries.
Eigen::MatrixXd equally_good_methods(Eigen::Index methods) {
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(query_count, methods);
  scores.topRows(7).setOnes();
  std::mt19937 random(1);
  for (Eigen::Index method = 0; method < methods; ++method) {
    std::ranges::shuffle(scores.col(method), random);
  }
  return scores;
}

std::vector<int> classes_of_six() {
  std::vector<int> classes;
  for (int query = 0; query < query_count; ++query) classes.push_back(query / 6);
  return classes;
}

TEST(EqualScores, IncludeScoresThatDifferByRounding) {
  EXPECT_TRUE(are_equal_scores(7.0 / 18, 7.0 / 18 - 5e-17));
  EXPECT_TRUE(are_equal_scores(0, 0));
  EXPECT_FALSE(are_equal_scores(0.5, 0.5 + 1e-11));
  EXPECT_FALSE(are_equal_scores(0, 1e-15));
  EXPECT_EQ(score_differences(Eigen::Vector2d(0.3, 0.5), Eigen::Vector2d(0.1 + 0.2, 0.25)), Eigen::Vector2d(0, 0.25));
}

TEST(EqualScores, FormGroupsByDescendingScore) {
  const Eigen::VectorXd scores = (Eigen::VectorXd(5) << 0.3, 0.9, 0.1 + 0.2, 0.5, 0.3).finished();
  EXPECT_THAT(groups_of_equal_scores(scores), ElementsAre(ElementsAre(1U), ElementsAre(3U), ElementsAre(0U, 2U, 4U)));
}

TEST(EqualScores, ShareARankInStandings) {
  for (const ResamplingUnit blocks : {ResamplingUnit::classes, ResamplingUnit::queries}) {
    const auto standings =
        standings_of(equally_good_methods(200), classes_of_six(), {.blocks = blocks, .resampling = {.resamples = 10}});
    for (const MethodStanding& standing : standings) EXPECT_EQ(standing.rank, 1U) << standing.average;
  }
}

// Sums of the same three numbers in another order; on each data set the methods are equal.
TEST(EqualScores, AreTiedInTheFriedmanTestAndWinCounts) {
  Eigen::MatrixXd scores(4, 3);
  for (Eigen::Index set = 0; set < 4; ++set) {
    scores.row(set) << (0.1 + 0.2) + 0.3, 0.1 + (0.2 + 0.3), set == 0 ? 0.7 : 0.1;
  }
  ASSERT_NE(scores(0, 0), scores(0, 1));
  const RankComparison comparison = compare_by_ranks(scores);
  EXPECT_EQ(comparison.ranks.row(0), Eigen::RowVector3d(2.5, 2.5, 1));
  EXPECT_EQ(comparison.ranks.row(1), Eigen::RowVector3d(1.5, 1.5, 3));
  EXPECT_EQ(comparison.pairs[0].data_sets.ties, 4);
  // 12 N / (k (k + 1)) * sum (mean rank - 2)^2 / (1 - ties / (N (k^3 - k))), worked by hand.
  EXPECT_NEAR(comparison.friedman.chi_squared, 4 * 0.375 / (1 - 24.0 / 96), 1e-12);
}

TEST(EqualScores, AreTiedInMethodComparisons) {
  Eigen::MatrixXd scores(query_count, 2);
  for (Eigen::Index query = 0; query < query_count; ++query) scores.row(query) << (0.1 + 0.2) + 0.3, 0.1 + (0.2 + 0.3);
  for (const PairTest test : {PairTest::randomisation, PairTest::t, PairTest::bootstrap}) {
    const MethodComparison comparison =
        compare_methods(scores, classes_of_six(), {.test = test, .resampling = {.resamples = 100}});
    EXPECT_EQ(comparison.pairs[0].difference, 0);
    EXPECT_EQ(comparison.pairs[0].p, 1);
    EXPECT_EQ(comparison.pairs[0].p_classes, 1);
    EXPECT_EQ(comparison.pairs[0].effect_size, 0);
    EXPECT_EQ(comparison.pairs[0].queries.ties, query_count);
  }
}

}  // namespace

}  // namespace shapegauge

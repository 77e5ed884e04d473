// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/method_comparison.h"
#include "shapegauge/metrics/significance_tests.h"
#include "tests/metrics/simulated_methods.h"

namespace shapegauge {

namespace {

// The third method is the first with 0.05 more on every query.
struct Example {
  Example() {
    const SimulatedMethods two = simulated_methods(30, 5, 8);
    classes = two.classes;
    per_query.resize(two.per_query.rows(), 3);
    per_query << two.per_query, two.per_query.col(0).array() + 0.05;
  }
  Eigen::MatrixXd per_query;
  std::vector<int> classes;
};

TEST(MethodComparison, ComparesAllPairsOfMethods) {
  const Example data;
  const MethodComparison result = compare_methods(data.per_query, data.classes);
  EXPECT_EQ(result.units, 150);
  EXPECT_EQ(result.classes, 30);
  ASSERT_EQ(result.pairs.size(), 3U);
  const PairDifference& constant = result.pairs[1];
  EXPECT_EQ(constant.first, 0U);
  EXPECT_EQ(constant.second, 2U);
  EXPECT_NEAR(constant.difference, -0.05, 1e-12);
  EXPECT_NEAR(constant.interval.low, -0.05, 1e-12);
  EXPECT_NEAR(constant.interval.high, -0.05, 1e-12);
  EXPECT_EQ(constant.p, 1.0 / 10001);
  EXPECT_EQ(constant.p_holm, 3.0 / 10001);
  EXPECT_EQ(constant.queries.losses, 150);
  EXPECT_EQ(constant.effect_size, -std::numeric_limits<double>::infinity());
  EXPECT_GE(constant.p_tukey, constant.p);
  EXPECT_NEAR(result.averages[2] - result.averages[0], 0.05, 1e-12);
}

TEST(MethodComparison, TukeyPValueOfAPairDoesNotDependOnTheReference) {
  const Example data;
  const MethodComparison result = compare_methods(data.per_query, data.classes);
  ASSERT_EQ(result.pairs.size(), 3U);
  for (const PairDifference& pair : result.pairs) {
    const MethodComparison alone = compare_methods(data.per_query, data.classes, {.reference = pair.first});
    const auto same = std::ranges::find(alone.pairs, pair.second, &PairDifference::second);
    EXPECT_EQ(pair.p_tukey, same->p_tukey);
  }
  // The larger the difference of two methods, the smaller the p-value.
  std::vector<PairDifference> by_distance = result.pairs;
  std::ranges::sort(by_distance, std::ranges::greater(),
                    [](const PairDifference& pair) { return std::abs(pair.difference); });
  EXPECT_LT(by_distance.front().p_tukey, by_distance.back().p_tukey);
  EXPECT_LE(by_distance[1].p_tukey, by_distance.back().p_tukey);
}

TEST(MethodComparison, ComparesTheReferenceWithEachOtherMethod) {
  const Example data;
  const MethodComparison result = compare_methods(data.per_query, data.classes, {.reference = 1});
  ASSERT_EQ(result.pairs.size(), 2U);
  EXPECT_EQ(result.pairs[0].first, 1U);
  EXPECT_EQ(result.pairs[0].second, 0U);
  EXPECT_EQ(result.pairs[1].second, 2U);
}

TEST(MethodComparison, EachTestFindsOnlyTheConstantDifferenceSignificant) {
  const Example data;
  for (const std::string& name : list_of_words<PairTest>()) {
    const PairTest test = value_of_word<PairTest>(name).value();
    EXPECT_EQ(name_of(test), name);
    const MethodComparison result = compare_methods(data.per_query, data.classes, {.test = test});
    EXPECT_LT(result.pairs[1].p, 0.001) << name;
    EXPECT_GT(result.pairs[0].p, 0.01) << name;
  }
}

TEST(MethodComparison, EqualMethodsHavePValueOne) {
  Example data;
  data.per_query.col(2) = data.per_query.col(0);
  for (const std::string& name : list_of_words<PairTest>()) {
    const PairDifference pair =
        compare_methods(data.per_query, data.classes, {.test = value_of_word<PairTest>(name).value()}).pairs[1];
    EXPECT_EQ(pair.p, 1) << name;
    EXPECT_EQ(pair.p_tukey, 1);
    EXPECT_EQ(pair.effect_size, 0);
    EXPECT_EQ(pair.queries.ties, 150);
  }
}

TEST(MethodComparison, RejectsASingleMethodASingleClassAndInfiniteScores) {
  const Example data;
  EXPECT_THROW(compare_methods(data.per_query.leftCols(1), data.classes), ArgumentError);
  EXPECT_THROW(compare_methods(data.per_query, std::vector<int>(150, 4), {.blocks = ResamplingUnit::classes}),
               ArgumentError);
  EXPECT_THROW(compare_methods(data.per_query, data.classes, {.reference = 3}), ArgumentError);
  Eigen::MatrixXd infinite = data.per_query;
  infinite(3, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(compare_methods(infinite, data.classes), ArgumentError);
}

// The randomisation of n units has 2^n outcomes, and the two with all signs equal are indistinguishable.
TEST(MethodComparison, SmallestPossiblePValueFollowsFromUnitsAndResamples) {
  EXPECT_EQ(min_attainable_p_value({}, 3), 0.25);
  EXPECT_EQ(min_attainable_p_value({.resampling = {.resamples = 9}}, 30), 0.1);
  EXPECT_EQ(min_attainable_p_value({.test = PairTest::bootstrap, .resampling = {.resamples = 99}}, 3), 0.01);
  EXPECT_EQ(min_attainable_p_value({.test = PairTest::t}, 3), 0);
  const Eigen::MatrixXd plain{{0, 1}, {0.1, 1}, {0.2, 1}};
  const double p = compare_methods(plain, std::vector<int>{0, 1, 2}).pairs[0].p;  // as many classes as queries
  EXPECT_NEAR(p, min_attainable_p_value({}, 3), 0.02);                            // of 10,000 resamples
}

TEST(ClassPValue, MatchesTheTTestOfClassMeans) {
  // Means 0.5, 0.1 and 0.3: t = 0.3 / (0.2 / sqrt(3)).
  const Eigen::VectorXd differences = (Eigen::VectorXd(5) << 0.4, 0.6, 0.1, 0.2, 0.4).finished();
  const std::vector<int> classes = {0, 0, 1, 2, 2};
  EXPECT_NEAR(class_p_value(differences, classes), 0.12168993434632014, 1e-12);
  EXPECT_EQ(class_p_value(-differences, classes), class_p_value(differences, classes));
}

TEST(ClassPValue, IsLargeForADifferenceInOneClassOnly) {
  // 140 queries of one class are better, the two other classes are a little worse.
  Eigen::VectorXd differences = Eigen::VectorXd::Ones(160);
  differences.tail(20).setConstant(-0.2);
  std::vector<int> classes(140, 0);
  classes.insert(classes.end(), 10, 1);
  classes.insert(classes.end(), 10, 2);
  Eigen::MatrixXd per_query = Eigen::MatrixXd::Zero(160, 2);
  per_query.col(0) = differences;
  const PairDifference pair = compare_methods(per_query, classes).pairs[0];
  EXPECT_EQ(pair.p_holm, 1.0 / 10001);
  EXPECT_GT(pair.p_classes, 0.5);
}

TEST(ClassPValue, IsOneForASingleClassOrClassesThatContradictTheAverage) {
  EXPECT_EQ(class_p_value(Eigen::VectorXd::Ones(9), std::vector<int>(9, 3)), 1);
  EXPECT_EQ(class_p_value(Eigen::VectorXd::Zero(4), std::vector<int>{0, 0, 1, 1}), 1);
  // The differences of each class cancel, except for the rounding of their sum.
  const Eigen::VectorXd cancelling = Eigen::Vector3d(0.1, 0.2, -0.3).replicate<2, 1>();
  EXPECT_EQ(class_p_value(cancelling, std::vector<int>{0, 0, 0, 1, 1, 1}), 1);
  // The average over queries is positive, the mean of classes negative.
  const Eigen::VectorXd opposite = (Eigen::VectorXd(6) << 1, 1, 1, 1, -1, -0.9).finished();
  EXPECT_EQ(class_p_value(opposite, std::vector<int>{0, 0, 0, 0, 1, 2}), 1);
  EXPECT_EQ(class_p_value(Eigen::VectorXd::Constant(6, 0.5), std::vector<int>{0, 0, 1, 1, 2, 2}), 0.25);
}

TEST(MinClassEffect, GrowsWithTheNumberOfPairsAndFallsWithMoreClasses) {
  EXPECT_NEAR(min_class_effect(6, 1, 0.05), 2.570581835636314 / std::sqrt(6.0), 1e-12);
  EXPECT_GT(min_class_effect(6, 325, 0.05), 4);
  EXPECT_LT(min_class_effect(30, 325, 0.05), 1);
  EXPECT_EQ(min_class_effect(1, 1, 0.05), std::numeric_limits<double>::infinity());
}

TEST(MethodComparison, TTestWeighsQueriesLikeTheMacroAverage) {
  // One class of three queries and one of one: under macro the last query counts three times as much as the others.
  const Eigen::MatrixXd per_query{{0.5, 0.4}, {0.7, 0.4}, {0.3, 0.1}, {0.9, 0.2}};
  const std::vector<int> classes = {0, 0, 0, 1};
  const MethodComparison result = compare_methods(
      per_query, classes, {.test = PairTest::t, .blocks = ResamplingUnit::queries, .average = Average::macro});
  const Eigen::VectorXd terms = (Eigen::VectorXd(4) << 0.1 * 2 / 3, 0.3 * 2 / 3, 0.2 * 2 / 3, 0.7 * 2).finished();
  ASSERT_EQ(result.pairs.size(), 1U);
  EXPECT_NEAR(result.pairs[0].difference, terms.mean(), 1e-15);
  EXPECT_NEAR(result.pairs[0].p, paired_t_p_value(terms), 1e-12);
  EXPECT_GT(std::abs(result.pairs[0].p - paired_t_p_value(per_query.col(0) - per_query.col(1))), 0.1);
}

}  // namespace

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <rapidcheck/gtest.h>

#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/protocol.h"
#include "tests/metrics/random_cases.h"

namespace shapegauge {

namespace {

TEST(Protocol, ConvertsToAndFromNames) {
  EXPECT_THAT(list_of_words<Protocol>(), testing::ElementsAre("psb", "paper", "trec"));
  for (const std::string& name : list_of_words<Protocol>()) {
    const auto protocol = value_of_word<Protocol>(name);
    ASSERT_TRUE(protocol) << name;
    EXPECT_EQ(name_of(*protocol), name);
  }
  EXPECT_EQ(value_of_word<Protocol>("psb"), Protocol::psb);
  EXPECT_EQ(value_of_word<Protocol>("paper"), Protocol::paper);
}

TEST(Protocol, RejectsUnknownNames) {
  EXPECT_FALSE(value_of_word<Protocol>(""));
  EXPECT_FALSE(value_of_word<Protocol>("PSB"));
  EXPECT_FALSE(value_of_word<Protocol>("psb "));
}

constexpr double protocol_rounding = 1e-13;

Evaluation evaluate_case(const EvaluationCase& data, Ties ties) {
  EvaluationOptions options;
  options.protocol = data.protocol;
  options.ties = ties;
  options.measures = measures_of(naive::measure_names());
  return evaluate(data.distances, data.labels, options);
}

Eigen::RowVectorXd as_row(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::RowVectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// Results of a query for every order of tied models: each order of all models breaks ties in one way, and all ways
// are equally frequent.
std::vector<Eigen::RowVectorXd> all_orders(const EvaluationCase& data, Eigen::Index query) {
  std::vector<int> order(data.labels.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<Eigen::RowVectorXd> values;
  do {
    values.push_back(
        as_row(naive::measures_of(data.distances, data.labels, static_cast<int>(query), data.protocol, order)));
  } while (std::next_permutation(order.begin(), order.end()));
  return values;
}

TEST(TieOrders, ConvertToAndFromNames) {
  EXPECT_THAT(list_of_words<Ties>(), testing::ElementsAre("index", "optimistic", "pessimistic", "expected"));
  for (const std::string& name : list_of_words<Ties>()) EXPECT_EQ(name_of(value_of_word<Ties>(name).value()), name);
  EXPECT_FALSE(value_of_word<Ties>("random"));
}

// Brute force, for data sets of up to six models: the mean over all 720 orders, the best and the worst.
RC_GTEST_PROP(TieOrders, ExpectedScoreIsTheMeanAndBoundsTheExtremesOverAllOrders, ()) {
  const EvaluationCase data = *cases_with_ties(6);
  const Evaluation expected = evaluate_case(data, Ties::expected);
  const Evaluation optimistic = evaluate_case(data, Ties::optimistic);
  const Evaluation pessimistic = evaluate_case(data, Ties::pessimistic);
  Eigen::Index changed = 0;
  for (std::size_t i = 0; i < expected.queries.size(); ++i) {
    const std::vector<Eigen::RowVectorXd> values = all_orders(data, expected.queries[i]);
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(values[0].size());
    Eigen::RowVectorXd least = values[0];
    Eigen::RowVectorXd most = values[0];
    for (const Eigen::RowVectorXd& value : values) {
      sum += value;
      least = least.cwiseMin(value);
      most = most.cwiseMax(value);
    }
    const auto row = static_cast<Eigen::Index>(i);
    const auto count = static_cast<double>(values.size());
    RC_ASSERT((expected.per_query.row(row) - sum / count).cwiseAbs().maxCoeff() <= protocol_rounding);
    RC_ASSERT((optimistic.per_query.row(row) - most).cwiseAbs().maxCoeff() <= protocol_rounding);
    RC_ASSERT((pessimistic.per_query.row(row) - least).cwiseAbs().maxCoeff() <= protocol_rounding);
    if (least != most) ++changed;
  }
  // DCG or nDCG changes with the rank of any hit, but for ranks 1 and 2 under DCG.
  RC_ASSERT(expected.queries_with_ties == changed);
}

RC_GTEST_PROP(TieOrders, ExpectedAveragesDoNotDependOnTheOrderOfModels, ()) {
  const EvaluationCase data = *cases_with_ties();
  std::vector<Eigen::Index> order(data.labels.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  std::ranges::shuffle(order, random);
  EvaluationCase permuted = data;
  permuted.distances = data.distances(order, order);
  for (std::size_t i = 0; i < order.size(); ++i) {
    permuted.labels[i] = data.labels[static_cast<std::size_t>(order[i])];
  }
  const Evaluation before = evaluate_case(data, Ties::expected);
  const Evaluation after = evaluate_case(permuted, Ties::expected);
  RC_ASSERT((before.micro - after.micro).cwiseAbs().maxCoeff() <= protocol_rounding);
  RC_ASSERT((before.macro - after.macro).cwiseAbs().maxCoeff() <= protocol_rounding);
  RC_ASSERT(before.queries_with_ties == after.queries_with_ties);
}

RC_GTEST_PROP(TieOrders, GiveEqualScoresWithoutTies, ()) {
  const EvaluationCase data = *cases_without_ties();
  const Evaluation index = evaluate_case(data, Ties::index);
  RC_ASSERT(index.queries_with_ties == 0);
  for (const Ties ties : {Ties::optimistic, Ties::pessimistic, Ties::expected}) {
    RC_ASSERT(evaluate_case(data, ties).per_query == index.per_query);
  }
}

RC_GTEST_PROP(TieOrders, IndexAndExpectedScoresLieBetweenPessimisticAndOptimisticScores, ()) {
  const EvaluationCase data = *cases_with_ties();
  const Eigen::ArrayXXd most = evaluate_case(data, Ties::optimistic).per_query.array() + protocol_rounding;
  const Eigen::ArrayXXd least = evaluate_case(data, Ties::pessimistic).per_query.array() - protocol_rounding;
  for (const Ties ties : {Ties::index, Ties::expected}) {
    const Eigen::ArrayXXd values = evaluate_case(data, ties).per_query.array();
    RC_ASSERT((values <= most).all() && (values >= least).all());
  }
}

RC_GTEST_PROP(TieOrders, FirstTierBoundsEqualPessimisticAndOptimisticScores, ()) {
  const EvaluationCase data = *cases_with_ties();
  const auto first_tier = [&](Ties ties) {
    return evaluate(data.distances, data.labels,
                    {.protocol = data.protocol, .ties = ties, .measures = {measure_of("FT")}})
        .micro[0];
  };
  for (const Ties ties : {Ties::index, Ties::expected}) {
    const FirstTierBounds bounds = evaluate_case(data, ties).first_tier_bounds;
    RC_ASSERT(bounds.pessimistic == first_tier(Ties::pessimistic));
    RC_ASSERT(bounds.optimistic == first_tier(Ties::optimistic));
  }
}

// All distances equal: every order is equally likely, and a list of N - 1 ranks with R hits anywhere has the mean
// R / (N - 1) at rank 1.
TEST(TieOrders, ExpectedScoresOfEqualDistancesAreTheScoresByChance) {
  EvaluationCase data{naive::Matrix::Ones(600, 600), {}, Protocol::psb};
  for (int model = 0; model < 600; ++model) data.labels.push_back(model / 20);
  const Evaluation result = evaluate_case(data, Ties::expected);
  EXPECT_EQ(result.queries_with_ties, 600);
  EXPECT_NEAR(result.micro[0], 19.0 / 599, 1e-12);
  EXPECT_NEAR(result.micro[1], 19.0 / 599, 1e-12);
  EXPECT_NEAR(result.micro[2], 38.0 / 599, 1e-12);
  EXPECT_NEAR(result.micro[3], 2 * 32 * 19.0 / 599 / 51, 1e-12);
}

}  // namespace

}  // namespace shapegauge

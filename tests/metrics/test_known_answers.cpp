// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <vector>

#include "shapegauge/metrics/evaluation.h"
#include "tests/metrics/random_cases.h"

// The known answers of docs/reference/definitions.md#measures.

namespace shapegauge {
namespace {

EvaluationOptions by_protocol(Protocol protocol) {
  EvaluationOptions options;
  options.protocol = protocol;
  return options;
}

// 30 classes of 20; models of one class are nearer to each other than to all others.
struct PerfectData {
  naive::Matrix distances = naive::Matrix(600, 600);
  std::vector<int> labels;
  PerfectData() {
    for (int model = 0; model < 600; ++model) labels.push_back(model % 30);
    for (Eigen::Index i = 0; i < 600; ++i) {
      for (Eigen::Index j = 0; j < 600; ++j) distances(i, j) = i % 30 == j % 30 ? 0.5 : 1.0;
    }
  }
};

void expect_measures(const Eigen::VectorXd& actual, const std::array<double, 5>& expected, double tolerance) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(actual[static_cast<Eigen::Index>(i)], expected.at(i), tolerance) << "measure " << i;
  }
}

TEST(PerfectRetrieval, HasTheKnownScoresUnderThePsbProtocol) {
  const PerfectData data;
  const Evaluation result = evaluate(data.distances, data.labels, by_protocol(Protocol::psb));
  expect_measures(result.micro, {1, 1, 1, 38.0 / 51.0, 1}, 1e-14);
  EXPECT_NEAR(result.micro[3], 0.7451, 5e-5);
  EXPECT_EQ(result.micro[5], 1);
  EXPECT_EQ(result.queries.size(), 600U);
  EXPECT_EQ(result.excluded_models, 0);
  for (const double precision : result.micro_curve.precision) EXPECT_EQ(precision, 1);
}

TEST(PerfectRetrieval, HasTheKnownScoresUnderThePaperProtocol) {
  const PerfectData data;
  const Evaluation result = evaluate(data.distances, data.labels, by_protocol(Protocol::paper));
  expect_measures(result.micro, {1, 1, 1, 40.0 / 52.0, 1}, 1e-14);
  EXPECT_NEAR(result.micro[3], 0.7692, 5e-5);
  EXPECT_EQ(result.micro[5], 1);
  for (const double precision : result.micro_curve.precision) EXPECT_EQ(precision, 1);
}

TEST(Evaluation, MatchesScoresComputedByHandForSevenModels) {
  const std::vector<double> values = {0, 1, 4, 2, 3.5, 7, 9};
  const std::vector<int> labels = {0, 0, 0, 1, 1, 1, 1};
  naive::Matrix distances(7, 7);
  for (std::size_t i = 0; i < 7; ++i) {
    for (std::size_t j = 0; j < 7; ++j) {
      distances(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = std::abs(values[i] - values[j]);
    }
  }
  const Evaluation result = evaluate(distances, labels, by_protocol(Protocol::psb));
  expect_measures(result.micro, {.571429, .428571, .928571, .595238, .718910}, 5e-7);
}

RC_GTEST_PROP(FirstTier, OfThePsbProtocolFollowsFromThePaperProtocolAndClassSize, ()) {
  const EvaluationCase data = *cases_with_ties();
  const Evaluation psb = evaluate(data.distances, data.labels, by_protocol(Protocol::psb));
  const Evaluation paper = evaluate(data.distances, data.labels, by_protocol(Protocol::paper));
  RC_ASSERT(psb.queries == paper.queries);
  for (std::size_t i = 0; i < psb.queries.size(); ++i) {
    const int label = data.labels[static_cast<std::size_t>(psb.queries[i])];
    const auto size = static_cast<double>(std::ranges::count(data.labels, label));
    const auto row = static_cast<Eigen::Index>(i);
    if (paper.per_query(row, 1) == 0) continue;  // no answer
    RC_ASSERT(std::abs(psb.per_query(row, 1) - (size * paper.per_query(row, 1) - 1) / (size - 1)) < 1e-12);
  }
}

}  // namespace
}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/metrics/evaluators.h"
#include "tests/support/test_files.h"

// The expected values are those that the original programs printed for the same input, see
// docs/reference/definitions.md#evaluation-programs.

namespace shapegauge {

namespace {

// Rows of distances with many ties; `first` is the model of the first column.
std::string tied_distances(int rows, int columns, int first, bool all_models) {
  std::string text;
  for (int i = 0; i < rows; ++i) {
    for (int j = first; j < first + columns; ++j) {
      const int distance = all_models && i == j ? 0 : (7 * (i + 1) * (j + 1) + 3 * (i + j)) % 6;
      text += std::to_string(distance) + (j + 1 < first + columns ? " " : "\n");
    }
  }
  return text;
}

class EvaluationProgramProtocols : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& name, const std::string& text) const {
    return folder_.file(name, text);
  }

  static Evaluation evaluated(const EvaluationFiles& files, const std::string& evaluator) {
    return evaluate_files(files, options_of_evaluator(evaluator)).evaluation;
  }

  static void expect_scores(const Eigen::VectorXd& found, const std::vector<double>& printed, double rounding) {
    ASSERT_EQ(found.size(), std::ssize(printed));
    for (Eigen::Index i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i], printed[static_cast<std::size_t>(i)], rounding) << i;
    }
  }

  // Four queries and seven targets of two classes.
  [[nodiscard]] EvaluationFiles two_sets() const {
    return {.matrix = file("two.txt", tied_distances(4, 7, 4, false)),
            .labels = file("q.cla", "PSB 1\n2 4\n\na 0 2\n0\n2\n\nb 0 2\n1\n3\n"),
            .targets = file("t.cla", "PSB 1\n2 7\n\na 0 3\n0\n3\n4\n\nb 0 4\n1\n2\n5\n6\n")};
  }

 private:
  test::TemporaryFolder folder_;
};

constexpr double all_digits = 1e-14;

TEST_F(EvaluationProgramProtocols, ReproduceTheScoresOfTheProgramPsbTable) {
  // The class -1 has no queries, and neither has the class of two.
  const EvaluationFiles files{
      .matrix = file("all.txt", tied_distances(10, 10, 0, true)),
      .labels = file("l.cla", "PSB 1\n4 10\n\na 0 4\n0\n1\n2\n3\n\nb 0 3\n4\n5\n6\n\nc 0 2\n7\n8\n\n-1 0 1\n9\n")};
  const Evaluation found = evaluated(files, "psb_table");
  expect_scores(found.micro, {0.286, 0.286, 0.548, 0.442, 0.585}, 5e-4);
  expect_scores(found.macro, {0.250, 0.250, 0.500, 0.432, 0.560}, 5e-4);
}

TEST_F(EvaluationProgramProtocols, ReproduceTheScoresOfTheShrec21Program) {
  const Evaluation found = evaluated(two_sets(), "shrec21");
  expect_scores(found.micro, {0.75, 0.6875, 0.91666666666666663, 0.65580357142857149, 0.80134762348651689}, all_digits);
  const std::vector<double>& curve = found.micro_curve.precision;
  expect_scores(Eigen::Map<const Eigen::VectorXd>(curve.data(), std::ssize(curve)),
                {0.875, 0.875, 0.875, 0.8125, 0.7125, 0.7125, 0.6125, 0.6125, 0.56071428571428572, 0.56071428571428572,
                 0.56071428571428572},
                all_digits);
}

TEST_F(EvaluationProgramProtocols, ReproduceTheScoresOfPytorchMetricLearning) {
  expect_scores(evaluated(two_sets(), "pytorch_metric_learning").micro,
                {0.75, 0.3958333333333333, 0.359375, 0.6558035714285715, 0.8125}, all_digits);
  // The only model of the class d is no query.
  const EvaluationFiles files{.matrix = file("all.txt", tied_distances(10, 10, 0, true)),
                              .labels = file("l.csv", "id,class\n0,a\n1,a\n2,a\n3,a\n4,b\n5,b\n6,b\n7,c\n8,c\n9,d\n")};
  expect_scores(evaluated(files, "pytorch_metric_learning").micro,
                {0.2222222222222222, 0.2222222222222222, 0.17901234567901236, 0.3861552028218695, 0.41309523809523807},
                all_digits);
}

// q1 has ties, grades, a document that was not judged (-1) and one that is not in the judgements; q2 has ties; q3 has
// no relevant document; q4 has no list; q5 has no judgements.
TEST_F(EvaluationProgramProtocols, ReproduceTheScoresOfTrecEval) {
  EvaluationFiles files{
      .matrix = file("t.run",
                     "q1 Q0 d1 1 9 r\nq1 Q0 d2 2 7 r\nq1 Q0 d3 3 7 r\nq1 Q0 d4 4 7 r\nq1 Q0 d5 5 6 r\nq1 Q0 d6 6 5 r\n"
                     "q1 Q0 d7 7 4 r\nq1 Q0 d9 8 3 r\nq2 Q0 d3 1 0.5 r\nq2 Q0 d1 2 0.5 r\nq2 Q0 d2 3 0.25 r\n"
                     "q3 Q0 d1 1 2 r\nq3 Q0 d2 2 1 r\nq5 Q0 d1 1 1 r\n"),
      .qrels = file("t.qrels",
                    "q1 0 d1 0\nq1 0 d2 2\nq1 0 d3 0\nq1 0 d4 -1\nq1 0 d5 1\nq1 0 d6 0\nq1 0 d7 3\nq1 0 d8 1\n"
                    "q2 0 d2 1\nq2 0 d3 0\nq3 0 d1 0\nq3 0 d2 0\nq4 0 d1 1\n")};
  const Evaluation found = evaluated(files, "trec_eval");
  // map, Rprec, P_10, recall_10, recip_rank, ndcg, bpref
  expect_scores(found.micro, {0.2010, 0.0833, 0.1333, 0.5833, 0.1944, 0.3110, 0.0556}, 5e-5);
  EXPECT_NEAR(found.micro_curve.precision[7], 0.2540, 5e-5);  // iprec_at_recall
  EXPECT_NEAR(found.micro_curve.precision[8], 0.2540, 5e-5);
  EXPECT_NEAR(found.micro_curve.precision[9], 0.1111, 5e-5);
  files.unanswered = Unanswered::count;  // -c
  expect_scores(evaluated(files, "trec_eval").micro, {0.1507, 0.0625, 0.1000, 0.4375, 0.1458, 0.2332, 0.0417}, 5e-5);
}

// Lists have the query first, later or not at all; the model 7 is alone in its class.
TEST_F(EvaluationProgramProtocols, ReproduceTheScoresOfTheShapenet16Program) {
  const EvaluationFiles files{
      .matrix = file("s.lists", "1 2 1 5 4\n2 2 1 6 3 7\n4 7 2 3\n5 1 6\n7 7 1\n"),
      .labels = file("s.csv", "id,class,subclass\n1,s,s\n2,s,s1\n3,s,s1\n4,s,s2\n5,t,t1\n6,t,t1\n7,u,u\n")};
  const Evaluation found = evaluated(files, "shapenet16");
  expect_scores(found.micro,
                {0.6033333333333334, 0.7000000000000001, 0.6309523809523809, 0.7833333333333333, 0.9364559070040945},
                all_digits);
  expect_scores(found.macro,
                {0.5574074074074074, 0.7222222222222221, 0.6097883597883597, 0.7685185185185184, 0.9646977261133858},
                all_digits);
}

}  // namespace

}  // namespace shapegauge

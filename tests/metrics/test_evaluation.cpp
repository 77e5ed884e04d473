// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <rapidcheck/gtest.h>
#include <set>
#include <string>
#include <tbb/global_control.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/metrics/evaluation.h"
#include "tests/metrics/random_cases.h"

namespace shapegauge {
namespace {

using testing::HasSubstr;

// Both sides sum the same numbers, of at most 60 models, in possibly different orders.
constexpr double rounding = 1e-13;

EvaluationOptions under(Protocol protocol, int minimum_class_size = 2) {
  EvaluationOptions options;
  options.protocol = protocol;
  options.minimum_class_size = minimum_class_size;
  return options;
}

Evaluation scores_of(const EvaluationCase& data, Ties ties = Ties::index) {
  EvaluationOptions options = under(data.protocol);
  options.measures = measures_of(naive::measure_names());
  options.ties = ties;
  return evaluate(data.distances, data.labels, options);
}

std::string error_of(const naive::Matrix& distances, const std::vector<int>& labels, const EvaluationOptions& options) {
  try {
    evaluate(distances, labels, options);
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "no error";
}

bool same_results(const Evaluation& a, const Evaluation& b) {
  return a.queries == b.queries && a.classes == b.classes && a.per_query == b.per_query && a.per_class == b.per_class &&
         a.micro == b.micro && a.macro == b.macro && a.micro_curve.precision == b.micro_curve.precision &&
         a.macro_curve.precision == b.macro_curve.precision;
}

int class_size(const std::vector<int>& labels, int label) {
  return static_cast<int>(std::ranges::count(labels, label));
}

TEST(Evaluation, NormalisedGainUsesTheRelevanceGradesOfEachQuery) {
  // All queries have the same order of models. To every other one what is highly relevant comes first, to the rest
  // last.
  constexpr Eigen::Index queries = 301;  // more than one block
  RetrievalTask task;
  task.target_classes = {0, 0, 0};
  for (Eigen::Index i = 0; i < queries; ++i) {
    task.query_classes.push_back(0);
    task.own_column.push_back(-1);
    task.judged.push_back({0, 2});
    task.grades.push_back(i % 2 == 0 ? std::vector{1, 3} : std::vector{3, 1});
  }
  const naive::Matrix distances = Eigen::RowVector3d(1, 2, 3).replicate<queries, 1>();
  EvaluationOptions options = under(Protocol::trec);
  options.measures = measures_of(std::vector<std::string>{"nDCG"});
  const RowSource rows = [&](Eigen::Index first, Eigen::Index count) -> naive::Matrix {
    return distances.middleRows(first, count);
  };
  const Evaluation evaluation = evaluate(rows, task, options);
  const double ideal = 3 + 1 / std::log2(3);
  for (Eigen::Index i = 0; i < queries; ++i) {
    EXPECT_NEAR(evaluation.per_query(i, 0), (i % 2 == 0 ? 1 + 3.0 / 2 : 3 + 1.0 / 2) / ideal, rounding) << i;
  }
}

RC_GTEST_PROP(Evaluation, ScoresOfEachQueryMatchANaiveImplementation, ()) {
  const EvaluationCase data = *cases_with_ties();
  const Evaluation result = scores_of(data);
  for (std::size_t i = 0; i < result.queries.size(); ++i) {
    const auto expected =
        naive::measures_of(data.distances, data.labels, static_cast<int>(result.queries[i]), data.protocol);
    for (std::size_t j = 0; j < expected.size(); ++j) {
      const double actual = result.per_query(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      RC_ASSERT(std::abs(actual - expected[j]) <= rounding);
    }
  }
}

RC_GTEST_PROP(Evaluation, RowByRowGivesTheScoresOfTheWholeMatrix, ()) {
  const EvaluationCase random = *cases_with_ties(600);
  const EvaluationOptions options{.protocol = random.protocol, .ties = Ties::expected};
  const Evaluation whole = evaluate(random.distances, random.labels, options);
  const RowSource rows = [&](Eigen::Index first, Eigen::Index count) -> DistanceMatrix {
    return random.distances.middleRows(first, count);
  };
  const Evaluation streamed = evaluate(rows, leave_one_out(random.labels), options);
  RC_ASSERT(streamed.queries == whole.queries);
  RC_ASSERT((streamed.per_query.array() == whole.per_query.array()).all());
  RC_ASSERT((streamed.macro.array() == whole.macro.array()).all());
  RC_ASSERT(streamed.micro_curve.precision == whole.micro_curve.precision);
  RC_ASSERT(streamed.queries_with_ties == whole.queries_with_ties);
}

RC_GTEST_PROP(Evaluation, UsesOnlyModelsOfLargeEnoughClassesAsQueries, ()) {
  const EvaluationCase data = *cases_with_ties();
  const int minimum = *rc::gen::inRange(2, 6);
  std::vector<Eigen::Index> queries;
  std::set<int> classes;
  for (std::size_t i = 0; i < data.labels.size(); ++i) {
    if (class_size(data.labels, data.labels[i]) < minimum) continue;
    queries.push_back(static_cast<Eigen::Index>(i));
    classes.insert(data.labels[i]);
  }
  if (queries.empty()) {
    RC_ASSERT_THROWS_AS(evaluate(data.distances, data.labels, under(data.protocol, minimum)), ArgumentError);
    return;
  }
  const Evaluation result = evaluate(data.distances, data.labels, under(data.protocol, minimum));
  RC_ASSERT(result.queries == queries);
  RC_ASSERT(result.classes == std::vector<int>(classes.begin(), classes.end()));
  RC_ASSERT(result.excluded_models == static_cast<Eigen::Index>(data.labels.size() - queries.size()));
}

RC_GTEST_PROP(Evaluation, AveragesAreMeansOverQueriesAndClasses, ()) {
  const EvaluationCase data = *cases_with_ties();
  const Evaluation result = scores_of(data);
  RC_ASSERT((result.micro - result.per_query.colwise().mean().transpose()).cwiseAbs().maxCoeff() <= rounding);
  RC_ASSERT((result.macro - result.per_class.colwise().mean().transpose()).cwiseAbs().maxCoeff() <= rounding);
  for (std::size_t c = 0; c < result.classes.size(); ++c) {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(result.per_query.cols());
    for (std::size_t i = 0; i < result.queries.size(); ++i) {
      const int label = data.labels[static_cast<std::size_t>(result.queries[i])];
      if (label == result.classes[c]) sum += result.per_query.row(static_cast<Eigen::Index>(i));
    }
    sum /= class_size(data.labels, result.classes[c]);
    RC_ASSERT((sum - result.per_class.row(static_cast<Eigen::Index>(c))).cwiseAbs().maxCoeff() <= rounding);
  }
}

// The mean over queries, or over the means of classes, of what the naive formulas give; where the protocol defines
// nothing for any query, the level is left out.
std::vector<double> naive_curve(const EvaluationCase& data, const Evaluation& result, bool macro) {
  std::map<int, std::vector<std::vector<double>>> groups;
  for (const Eigen::Index query : result.queries) {
    const int label = macro ? data.labels[static_cast<std::size_t>(query)] : static_cast<int>(query);
    groups[label].push_back(naive::precisions_of(data.distances, data.labels, static_cast<int>(query), data.protocol));
  }
  std::vector<double> curve;
  for (std::size_t level = 0; level < result.micro_curve.recall.size(); ++level) {
    double sum = 0;
    int counted = 0;
    for (const auto& [label, rows] : groups) {
      double of_group = 0;
      for (const auto& row : rows) of_group += row[level] / static_cast<double>(rows.size());
      if (std::isnan(of_group)) continue;
      sum += of_group;
      ++counted;
    }
    curve.push_back(sum / counted);
  }
  return curve;
}

RC_GTEST_PROP(Evaluation, PrecisionRecallCurvesMatchANaiveImplementation, ()) {
  const EvaluationCase data = *cases_with_ties();
  const Evaluation result = scores_of(data);
  for (const bool macro : {false, true}) {
    const auto expected = naive_curve(data, result, macro);
    const auto& actual = (macro ? result.macro_curve : result.micro_curve).precision;
    RC_ASSERT(actual.size() == expected.size());
    for (std::size_t level = 0; level < expected.size(); ++level) {
      if (std::isnan(expected[level])) continue;
      RC_ASSERT(std::abs(actual[level] - expected[level]) <= rounding);
    }
  }
}

RC_GTEST_PROP(Evaluation, ScoresLieBetweenZeroAndOne, ()) {
  const Evaluation result = scores_of(*cases_with_ties());
  // The negated comparison also fails for NaN.
  RC_ASSERT((result.per_query.array() >= 0 && result.per_query.array() <= 1).all());
  RC_ASSERT((result.per_class.array() >= 0 && result.per_class.array() <= 1 + rounding).all());
  for (const auto* const curve : {&result.micro_curve, &result.macro_curve}) {
    for (const double precision : curve->precision) RC_ASSERT(precision >= 0 && precision <= 1 + rounding);
  }
}

RC_GTEST_PROP(Evaluation, DependsOnlyOnTheOrderOfDistances, ()) {
  const EvaluationCase data = *cases_with_ties();
  EvaluationCase transformed = data;
  // Distances are 0, 0.25, ... 7.25 and infinity; cubes of those are exact, so ties stay and nothing else becomes one.
  transformed.distances = data.distances.unaryExpr([](double d) { return d * d * d - 5; });
  RC_ASSERT(same_results(scores_of(data), scores_of(transformed)));
}

RC_GTEST_PROP(Evaluation, IgnoresTheDiagonal, ()) {
  const EvaluationCase data = *cases_with_ties();
  EvaluationCase changed = data;
  changed.distances.diagonal().setConstant(std::numeric_limits<double>::infinity());
  RC_ASSERT(same_results(scores_of(data), scores_of(changed)));
}

RC_GTEST_PROP(Evaluation, ScoresOfModelsDoNotDependOnTheOrderOfModels, ()) {
  const EvaluationCase data = *cases_without_ties();
  std::vector<std::size_t> order(data.labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  std::ranges::shuffle(order, random);
  EvaluationCase permuted = data;
  for (std::size_t i = 0; i < order.size(); ++i) {
    permuted.labels[i] = data.labels[order[i]];
    for (std::size_t j = 0; j < order.size(); ++j) {
      permuted.distances(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          data.distances(static_cast<Eigen::Index>(order[i]), static_cast<Eigen::Index>(order[j]));
    }
  }
  const Evaluation before = scores_of(data);
  const Evaluation after = scores_of(permuted);
  std::map<Eigen::Index, Eigen::RowVectorXd> row_of_model;
  for (std::size_t i = 0; i < before.queries.size(); ++i) {
    row_of_model[before.queries[i]] = before.per_query.row(static_cast<Eigen::Index>(i));
  }
  RC_ASSERT(after.queries.size() == before.queries.size());
  for (std::size_t i = 0; i < after.queries.size(); ++i) {
    const auto model = static_cast<Eigen::Index>(order[static_cast<std::size_t>(after.queries[i])]);
    RC_ASSERT(after.per_query.row(static_cast<Eigen::Index>(i)) == row_of_model.at(model));
  }
}

TEST(Evaluation, IsTheSameOnAnyNumberOfThreads) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  const naive::Matrix distances = naive::Matrix::NullaryExpr(200, 200, [&] { return uniform(random); });
  std::vector<int> labels;
  for (int i = 0; i < 200; ++i) labels.push_back(static_cast<int>(std::sqrt(i)));
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return evaluate(distances, labels, under(Protocol::psb));
  };
  const Evaluation one = with_threads(1);
  EXPECT_TRUE(same_results(one, with_threads(2)));
  EXPECT_TRUE(same_results(one, with_threads(5)));
}

TEST(Evaluation, ContainsTheNamesOfProtocolAndMeasures) {
  const Evaluation result = evaluate(naive::Matrix::Zero(2, 2), std::vector<int>{4, 4}, under(Protocol::paper));
  EXPECT_EQ(result.protocol, Protocol::paper);
  EXPECT_EQ(result.curve, CurveKind::paper);
  EXPECT_THAT(result.measures, testing::ElementsAre("NN", "FT", "ST", "E", "DCG", "mAP"));
}

TEST(Evaluation, ReportsTheRowAndColumnOfNan) {
  naive::Matrix distances = naive::Matrix::Ones(4, 4);
  distances(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(error_of(distances, {0, 0, 1, 1}, {}), HasSubstr("row 2, column 1"));
}

TEST(Evaluation, RejectsInputsOfDifferentSizes) {
  EXPECT_THAT(error_of(naive::Matrix::Ones(2, 3), {0, 0}, {}), HasSubstr("square, not 2 x 3"));
  EXPECT_THAT(error_of(naive::Matrix::Ones(3, 3), {0, 0}, {}), HasSubstr("3 models, but 2"));
  EXPECT_THAT(error_of(naive::Matrix::Ones(3, 3), {0, 1, 2}, {}), HasSubstr("no class has 2"));
  EXPECT_THAT(error_of(naive::Matrix(0, 0), {}, {}), HasSubstr("no class has 2"));
  EXPECT_THAT(error_of(naive::Matrix::Ones(2, 2), {0, 0}, under(Protocol::psb, 0)),
              HasSubstr("minimum_class_size is 0"));
}

TEST(Evaluation, MinimumClassSizeOneIncludesJudgedQueriesWithoutRelevantModels) {
  RetrievalTask task;
  task.query_classes = {0, 1};
  task.target_classes = {0, 0};
  task.own_column = {-1, -1};
  task.judged = {{0}, {}};
  const DistanceMatrix distances{{1, 2}, {1, 2}};
  EXPECT_EQ(evaluate(distances, task, under(Protocol::trec, 2)).micro[0], 1);
  const Evaluation all = evaluate(distances, task, under(Protocol::trec, 1));
  EXPECT_EQ(all.micro[0], 0.5);
  EXPECT_EQ(all.micro_curve.precision[10], 0.5);
  // A class of one has no relevant model either, but nobody judged that.
  EXPECT_EQ(evaluate(naive::Matrix::Ones(3, 3), std::vector<int>{0, 0, 1}, under(Protocol::psb, 1)).queries.size(), 2U);
}

TEST(Evaluation, CountsTheQueryItselfAsAHitOnRequest) {
  const DistanceMatrix distances{{4, 0, 2}, {0, 0, 5}, {3, 1, 0}};
  EvaluationOptions options{.measures = measures_of(std::vector<std::string>{"NN", "R-prec"}), .finds_itself = true};
  const Evaluation found = evaluate(distances, std::vector<int>{0, 0, 1}, options);
  EXPECT_EQ(found.per_query, (Eigen::MatrixXd{{1, 0.5}, {1, 1}, {1, 1}})) << "a class of one finds its only model";
}

TEST(Evaluation, RejectsJudgementsWithoutRelevantModels) {
  RetrievalTask task;
  task.query_classes = {0, 1};
  task.target_classes = {0, 0};
  task.own_column = {-1, -1};
  task.judged = {{}, {}};
  const auto error = [&](int minimum) -> std::string {
    try {
      evaluate(DistanceMatrix::Ones(2, 2), task, under(Protocol::trec, minimum));
    } catch (const ArgumentError& refused) {
      return refused.what();
    }
    return "no error";
  };
  EXPECT_EQ(error(2), "no query has a relevant model");
  EXPECT_EQ(error(4), "no query has 3 relevant models or more");
}

TEST(Evaluation, GradedGainUnderThePaperProtocolCountsTheQueryAtRankOne) {
  // Four targets at distances 1 to 4; the first has grade 1, the third grade 3. The query, as relevant as anything,
  // gains 3 at rank 1; the others follow at ranks 2 and 4.
  RetrievalTask task;
  task.query_classes = {0};
  task.target_classes = {0, 0, 0, 0};
  task.own_column = {-1};
  task.judged = {{0, 2}};
  task.grades = {{1, 3}};
  task.judged_irrelevant = {{1, 3}};
  const DistanceMatrix distances{{1, 2, 3, 4}};
  EvaluationOptions options{.protocol = Protocol::paper, .measures = measures_of(std::vector<std::string>{"nDCG"})};
  const double ideal = 3 / std::log2(2) + 3 / std::log2(3) + 1 / std::log2(4);
  const double found = 3 / std::log2(2) + 1 / std::log2(3) + 3 / std::log2(5);
  EXPECT_NEAR(evaluate(distances, task, options).micro[0], found / ideal, 1e-15);
  options.protocol = Protocol::psb;
  EXPECT_NEAR(evaluate(distances, task, options).micro[0],
              (1 / std::log2(2) + 3 / std::log2(4)) / (3 / std::log2(2) + 1 / std::log2(3)), 1e-15);
}

TEST(Evaluation, MacroCurveIsTheMeanOfTheCurvesOfClasses) {
  // Class 0: a query that is no target (20 relevant models, the first at rank 1), and one that is (19, the first at
  // rank 2). At recall 0.05 the second has no precision yet. Class 1: a query whose first hit is at rank 4.
  RetrievalTask task;
  task.query_classes = {0, 0, 1};
  task.target_classes.assign(40, 0);
  task.own_column = {-1, 0, -1};
  std::fill(task.target_classes.begin() + 20, task.target_classes.end(), 1);
  DistanceMatrix distances(3, 40);
  for (Eigen::Index column = 0; column < 40; ++column) {
    const auto position = static_cast<double>(column);
    distances.col(column) << position, position + (column == 20 ? -19.5 : 0), column < 3 ? position : 100 - position;
  }
  const Evaluation result = evaluate(distances, task, {.curve = CurveKind::psb});
  ASSERT_EQ(result.micro_curve.recall.front(), 0.05);
  EXPECT_DOUBLE_EQ(result.class_curves[0].precision[0], 1);
  EXPECT_DOUBLE_EQ(result.class_curves[1].precision[0], 0.25);
  EXPECT_DOUBLE_EQ(result.micro_curve.precision[0], (1 + 0.25) / 2);
  EXPECT_DOUBLE_EQ(result.macro_curve.precision[0], (1 + 0.25) / 2);
  for (std::size_t level = 0; level < 20; ++level) {
    EXPECT_DOUBLE_EQ(result.macro_curve.precision[level],
                     (result.class_curves[0].precision[level] + result.class_curves[1].precision[level]) / 2);
  }
}

TEST(Evaluation, BinaryPreferenceRowByRowEqualsThatOfTheWholeMatrix) {
  // More queries than one block, each with its own relevant, irrelevant and unjudged models.
  constexpr Eigen::Index queries = 300;
  RandomNumbers random(5);
  RetrievalTask task;
  task.target_classes.assign(30, 0);
  DistanceMatrix distances(queries, 30);
  for (Eigen::Index row = 0; row < queries; ++row) {
    task.query_classes.push_back(static_cast<int>(row));
    task.own_column.push_back(-1);
    auto& relevant = task.judged.emplace_back();
    auto& irrelevant = task.judged_irrelevant.emplace_back();
    for (Eigen::Index column = 0; column < 30; ++column) {
      distances(row, column) = random.uniform(0, 1);
      const std::uint64_t kind = column < 2 ? static_cast<std::uint64_t>(column) : random.below(3);
      if (kind == 0) relevant.push_back(column);
      if (kind == 1) irrelevant.push_back(column);
    }
    task.grades.emplace_back(relevant.size(), 1);
  }
  const EvaluationOptions options{.measures = measures_of(std::vector<std::string>{"bpref"})};
  const Evaluation by_rows = evaluate(
      [&](Eigen::Index first, Eigen::Index count) -> DistanceMatrix { return distances.middleRows(first, count); },
      task, options);
  EXPECT_EQ(by_rows.per_query, evaluate(distances, task, options).per_query);
  for (Eigen::Index row = 0; row < queries; ++row) {  // direct evaluation
    const auto i = static_cast<std::size_t>(row);
    const auto bound = static_cast<double>(std::min(task.judged[i].size(), task.judged_irrelevant[i].size()));
    double sum = 0;
    for (const Eigen::Index hit : task.judged[i]) {
      const auto before = std::ranges::count_if(
          task.judged_irrelevant[i], [&](Eigen::Index miss) { return distances(row, miss) < distances(row, hit); });
      sum += 1 - static_cast<double>(std::min<std::ptrdiff_t>(before, std::ssize(task.judged[i]))) / bound;
    }
    EXPECT_NEAR(by_rows.per_query(row, 0), sum / static_cast<double>(task.judged[i].size()), 1e-12) << row;
  }
}

TEST(Evaluation, RawCurvesHaveALevelForEachRelevantModelOfTheLargestClass) {
  EvaluationOptions options = under(Protocol::psb);
  options.curve = CurveKind::raw;
  const std::vector<int> labels = {0, 0, 0, 1, 1};
  EXPECT_EQ(evaluate(naive::Matrix::Ones(5, 5), labels, options).micro_curve.recall, (std::vector<double>{0.5, 1}));
  // Under paper the query is one of them.
  options.protocol = Protocol::paper;
  EXPECT_EQ(evaluate(naive::Matrix::Ones(5, 5), labels, options).micro_curve.recall,
            (std::vector<double>{1.0 / 3, 2.0 / 3, 1}));
}

}  // namespace
}  // namespace shapegauge

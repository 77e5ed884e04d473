// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gmock/gmock.h>
#include <iterator>
#include <limits>
#include <rapidcheck/gtest.h>
#include <set>
#include <span>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/ranked_list.h"
#include "shapegauge/metrics/retrieval_failures.h"
#include "tests/metrics/random_cases.h"

namespace shapegauge {

namespace {

using Nearest = std::vector<std::int32_t>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using testing::ElementsAre;

/// Distances between numbers on a line.
Matrix on_a_line(const std::vector<double>& coordinates) {
  const auto count = static_cast<Eigen::Index>(coordinates.size());
  const Eigen::VectorXd column = Eigen::Map<const Eigen::VectorXd>(coordinates.data(), count);
  return (column.replicate(1, count) - column.transpose().replicate(count, 1)).cwiseAbs();
}

/// Nearest model of each.
Nearest nearest_of(const Matrix& distances) {
  Nearest nearest;
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    const std::span row(distances.row(i).data(), static_cast<std::size_t>(distances.cols()));
    nearest.push_back(static_cast<std::int32_t>(first_ranked(row, i, 1).front()));
  }
  return nearest;
}

TEST(ConfusionMatrix, CountsTheClassesOfNearestNeighbours) {
  // The example of the known answers. Nearest: 0 -> 1, 1 -> 0 (a tie with 2, decided by index), 4 -> 3.5, 2 -> 1, 3.5
  // -> 4, 7 -> 9, 9 -> 7.
  const std::vector<int> labels = {0, 0, 0, 1, 1, 1, 1};
  const std::vector<Eigen::Index> queries = {0, 1, 2, 3, 4, 5, 6};
  const Eigen::MatrixXi expected{{2, 1}, {2, 2}};
  EXPECT_EQ(confusion_matrix(nearest_of(on_a_line({0, 1, 4, 2, 3.5, 7, 9})), labels, queries, 2), expected);
}

TEST(ConfusionMatrix, CountsOnlyQueriesButNearestModelsOfTheWholeCollection) {
  const std::vector<int> labels = {2, 0, 2};
  const std::vector<Eigen::Index> queries = {0, 2};
  const Eigen::MatrixXi expected{{0, 0, 0}, {0, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(confusion_matrix(nearest_of(on_a_line({0, 1, 2})), labels, queries, 3), expected);
}

RC_GTEST_PROP(ConfusionMatrix, DiagonalMatchesTheNearestNeighbourMeasure, ()) {
  const EvaluationCase random = *cases_with_ties();
  const std::set<int> names(random.labels.begin(), random.labels.end());
  std::vector<int> labels;
  for (const int name : random.labels) {
    labels.push_back(static_cast<int>(std::distance(names.begin(), names.find(name))));
  }
  const Evaluation evaluation =
      evaluate(random.distances, labels, {.protocol = random.protocol, .measures = {measure_of("NN")}});
  const Nearest nearest = nearest_of(random.distances);
  std::vector<Eigen::Index> answered;  // NN is 0 for the others, which have no nearest neighbour
  std::ranges::copy_if(evaluation.queries, std::back_inserter(answered), [&](Eigen::Index query) {
    return random.distances(query, nearest[static_cast<std::size_t>(query)]) < std::numeric_limits<double>::infinity();
  });
  const Eigen::MatrixXi confusion = confusion_matrix(nearest, labels, answered, static_cast<int>(names.size()));
  RC_ASSERT(confusion.sum() == static_cast<int>(answered.size()));
  for (std::size_t i = 0; i < evaluation.classes.size(); ++i) {
    const int label = evaluation.classes[i];
    const double right =
        evaluation.per_class(static_cast<Eigen::Index>(i), 0) * static_cast<double>(std::ranges::count(labels, label));
    RC_ASSERT(std::abs(right - confusion(label, label)) < 1e-9);
  }
}

TEST(ConfusionMatrix, RejectsLabelsQueriesAndNearestIndicesOutOfRange) {
  const std::vector<int> labels = {0, 1, 0};
  const std::vector<Eigen::Index> queries = {0};
  const Nearest nearest = {1, 0, 1};
  EXPECT_THROW(confusion_matrix(nearest, labels, queries, 1), ArgumentError) << "label 1 of 1 class";
  EXPECT_THROW(confusion_matrix(nearest, labels, std::vector<Eigen::Index>{3}, 2), ArgumentError);
  EXPECT_THROW(confusion_matrix(Nearest{1, 0}, labels, queries, 2), ArgumentError);
  EXPECT_THROW(confusion_matrix(Nearest{1, 0, 3}, labels, queries, 2), ArgumentError);
}

Evaluation evaluation() {
  Evaluation evaluation;
  evaluation.measures = {"NN", "FT"};
  evaluation.queries = {3, 5, 7, 9};
  evaluation.per_query = Eigen::MatrixXd{{1, 0.5}, {0, 0.25}, {1, 0.5}, {0, 0.75}};
  return evaluation;
}

TEST(WorstQueries, AreSortedByScoreAndThenByIndex) {
  EXPECT_THAT(worst_queries(evaluation(), "FT", 3), ElementsAre(1, 0, 2));
  EXPECT_THAT(worst_queries(evaluation(), "NN", 4), ElementsAre(1, 3, 0, 2));
}

TEST(WorstQueries, AreAtMostTheNumberOfQueries) {
  EXPECT_THAT(worst_queries(evaluation(), "FT", 10), ElementsAre(1, 0, 2, 3));
  EXPECT_THAT(worst_queries(evaluation(), "FT", 0), ElementsAre());
}

TEST(WorstQueries, RejectAnUnknownMeasure) { EXPECT_THROW(worst_queries(evaluation(), "mAP", 1), ArgumentError); }

}  // namespace

}  // namespace shapegauge

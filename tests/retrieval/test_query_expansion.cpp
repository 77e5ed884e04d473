// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/retrieval/query_expansion.h"
#include "tests/retrieval/reranking_examples.h"

namespace shapegauge {

namespace {

using test::arcs;
using test::distances_of;
using test::expect_near;
using test::largest_finite;
using test::mean_with_transposed;
using test::nearest_of;
using test::no_neighbour;
using test::with_gaps;

/// Query expansion by direct evaluation of its definition.
DistanceMatrix expansion_reference(const DistanceMatrix& distances, std::size_t k) {
  DistanceMatrix result = distances;
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    std::vector<Eigen::Index> rows = nearest_of(distances, i, k);
    rows.insert(rows.begin(), i);
    for (Eigen::Index j = 0; j < distances.cols(); ++j) {
      double sum = 0;
      double weights = 0;
      bool all_infinite = true;
      for (std::size_t r = 0; r < rows.size(); ++r) {
        const double weight = 1.0 / (1.0 + static_cast<double>(r));
        const double distance = distances(rows[r], j);
        sum += weight * (std::isinf(distance) ? largest_finite(distances) : distance);
        weights += weight;
        all_infinite = all_infinite && std::isinf(distance);
      }
      result(i, j) = all_infinite ? no_neighbour : sum / weights;
    }
  }
  return mean_with_transposed(result);
}

TEST(QueryExpansion, MatchesADirectImplementation) {
  const DistanceMatrix plain = distances_of(arcs(15, 3, 1));
  for (const DistanceMatrix& distances : {plain, with_gaps(plain)}) {
    expect_near(query_expansion(distances, {.neighbours = 4}), expansion_reference(distances, 4), 1e-12);
  }
}

TEST(QueryExpansion, IsTheWeightedMeanOfRowsOfAQueryAndItsNeighbours) {
  const Eigen::MatrixXd points{{0}, {1}, {3}};
  // Rows with their nearest: (0 1 3) + (1 0 2) / 2, over 1.5; (1 0 2) + (0 1 3) / 2; (3 2 0) + (1 0 2) / 2.
  const DistanceMatrix found = query_expansion(distances_of(points), {.neighbours = 1});
  EXPECT_NEAR(found(0, 1), ((1 + 0.0) / 1.5 + (1 + 0.0) / 1.5) / 2, 1e-15);
  EXPECT_NEAR(found(0, 2), ((3 + 1.0) / 1.5 + (3 + 0.5) / 1.5) / 2, 1e-15);
}

TEST(QueryExpansion, AveragesDistancesOverSeveralNeighbourCounts) {
  const DistanceMatrix distances = distances_of(arcs(15, 3, 1));
  const auto alone = [&](std::int64_t k) { return query_expansion(distances, {.neighbours = {k}}); };
  expect_near(query_expansion(distances, {.neighbours = {8, 2, 5}}), (alone(2) + alone(5) + alone(8)) / 3, 1e-12);
  EXPECT_EQ(query_expansion(distances, {.neighbours = {}}),
            query_expansion(distances, {.neighbours = {4, 5, 7, 10, 14, 20}}));
}

}  // namespace

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "shapegauge/retrieval/k_reciprocal.h"
#include "tests/retrieval/reranking_examples.h"

namespace shapegauge {

namespace {

using test::arcs;
using test::clusters;
using test::distances_of;
using test::expect_near;
using test::largest_finite;
using test::mean_with_transposed;
using test::nearest_of;
using test::no_neighbour;
using test::with_gaps;

using ModelSet = std::set<Eigen::Index>;

/// The model and its k-reciprocal neighbours.
ModelSet reciprocal_set(const DistanceMatrix& distances, Eigen::Index model, std::size_t k) {
  ModelSet found = {model};
  for (const Eigen::Index other : nearest_of(distances, model, k)) {
    const std::vector<Eigen::Index> theirs = nearest_of(distances, other, k);
    if (std::ranges::find(theirs, model) != theirs.end()) found.insert(other);
  }
  return found;
}

/// k-reciprocal re-ranking by its definition (Zhong et al. 2017, equations 2 to 12), evaluated directly with dense
/// vectors.
DistanceMatrix k_reciprocal_reference(const DistanceMatrix& distances, std::size_t k1, std::size_t k2, double lambda) {
  const Eigen::Index n = distances.rows();
  Eigen::MatrixXd v = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const ModelSet mutual = reciprocal_set(distances, i, k1);
    ModelSet expanded = mutual;
    for (const Eigen::Index q : mutual) {
      const ModelSet theirs = reciprocal_set(distances, q, k1 / 2);
      const auto common = std::ranges::count_if(theirs, [&](Eigen::Index j) { return mutual.contains(j); });
      if (static_cast<double>(common) > 2.0 / 3 * static_cast<double>(theirs.size())) {
        expanded.insert(theirs.begin(), theirs.end());
      }
    }
    double unit = 0;
    const std::vector<Eigen::Index> nearest = nearest_of(distances, i, k1);
    for (const Eigen::Index j : nearest) unit += distances(i, j) / static_cast<double>(nearest.size());
    for (const Eigen::Index j : expanded) v(i, j) = j == i ? 1 : std::exp(-distances(i, j) / unit);
    v.row(i) /= v.row(i).sum();
  }
  Eigen::MatrixXd means = v;
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::vector<Eigen::Index> nearest = nearest_of(distances, i, k2 - 1);
    for (const Eigen::Index j : nearest) means.row(i) += v.row(j);
    means.row(i) /= static_cast<double>(nearest.size() + 1);
  }
  DistanceMatrix result(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const double shared = means.row(i).cwiseMin(means.row(j)).sum();
      double original = distances(i, j) / largest_finite(distances);
      if (std::isinf(original) && shared > 0) original = 1;
      const double jaccard = 1 - shared / means.row(i).cwiseMax(means.row(j)).sum();
      result(i, j) = std::isinf(original) ? no_neighbour : (1 - lambda) * jaccard + lambda * original;
    }
  }
  return mean_with_transposed(result);
}

TEST(KReciprocalReranking, RanksMutualNeighboursBeforeOneSidedNeighbours) {
  // 0 to 3 are near each other; 4 is nearer to 3 than 0 is, but its own neighbours are nearer.
  const std::vector<double> coordinates = {0, 1, 2, 3, 5.5, 5.6, 5.7, 5.8};
  Eigen::MatrixXd points(8, 1);
  for (std::size_t i = 0; i < coordinates.size(); ++i) points(static_cast<Eigen::Index>(i), 0) = coordinates[i];
  const DistanceMatrix distances = distances_of(points);
  ASSERT_LT(distances(3, 4), distances(3, 0));
  const DistanceMatrix found = k_reciprocal(distances, {.neighbours = 3, .expansion_neighbours = 2, .original = 0});
  EXPECT_GT(found(3, 4), found(3, 0));
  EXPECT_NEAR(found(3, 4), 1, 1e-12);
}

TEST(KReciprocalReranking, MatchesADirectImplementation) {
  for (const DistanceMatrix& plain : {distances_of(arcs(9, 3, 1)), distances_of(clusters(8, 4, 2))}) {
    for (const DistanceMatrix& distances : {plain, with_gaps(plain)}) {
      for (const int k1 : {5, 8}) {
        for (const int k2 : {1, 4}) {
          const DistanceMatrix found =
              k_reciprocal(distances, {.neighbours = k1, .expansion_neighbours = k2, .original = 0.3});
          expect_near(
              found, k_reciprocal_reference(distances, static_cast<std::size_t>(k1), static_cast<std::size_t>(k2), 0.3),
              1e-12);
        }
      }
    }
  }
}

TEST(KReciprocalReranking, AveragesDistancesOverSeveralNeighbourCounts) {
  const DistanceMatrix plain = distances_of(arcs(9, 3, 1));
  for (const DistanceMatrix& distances : {plain, with_gaps(plain)}) {
    const auto alone = [&](std::int64_t k, int expansion) {
      return k_reciprocal(distances, {.neighbours = {k}, .expansion_neighbours = expansion});
    };
    DistanceMatrix expected = (alone(3, 3) + alone(5, 4) + alone(8, 4)) / 3;
    const DistanceMatrix found = k_reciprocal(distances, {.neighbours = {5, 3, 8}, .expansion_neighbours = 4});
    // Sets that are joined for some of the numbers only give finite distances: then all of the others' Jaccard is 1.
    expected = (found.array().isFinite() && !expected.array().isFinite()).select(found, expected);
    expect_near(found, expected, 1e-12);
  }
  EXPECT_EQ(k_reciprocal(plain, {.neighbours = {}}), k_reciprocal(plain, {.neighbours = {4, 5, 7, 10, 14, 20}}));
}

}  // namespace

}  // namespace shapegauge

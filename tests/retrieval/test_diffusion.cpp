// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/retrieval/diffusion.h"
#include "tests/retrieval/reranking_examples.h"

namespace shapegauge {

namespace {

using test::arcs;
using test::clusters;
using test::diffused_by_rows;
using test::distances_of;
using test::expect_near;
using test::first_tier;
using test::largest_difference;
using test::largest_finite;
using test::mean_with_transposed;
using test::nearest_of;
using test::no_neighbour;
using test::with_gaps;

Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& positive_definite) {
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(positive_definite.rows(), positive_definite.cols());
  return positive_definite.llt().solve(identity);
}

/// (I - damping D^-1/2 A D^-1/2)^-1 by direct evaluation of its definition.
Eigen::MatrixXd affinity_reference(const DistanceMatrix& distances, std::size_t k, double damping) {
  const Eigen::Index n = distances.rows();
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd s = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::vector<Eigen::Index> nearest = nearest_of(distances, i, k);
    for (const Eigen::Index j : nearest) s[i] += distances(i, j) / static_cast<double>(nearest.size());
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    for (const Eigen::Index j : nearest_of(distances, i, k)) {
      w(i, j) = std::exp(-distances(i, j) * distances(i, j) / (s[i] * s[j]));
    }
  }
  const Eigen::MatrixXd a = (w + w.transpose()) / 2;
  const Eigen::VectorXd degrees = a.rowwise().sum();
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      if (a(i, j) > 0) system(i, j) -= damping * a(i, j) / std::sqrt(degrees[i] * degrees[j]);
    }
  }
  return inverse_of(system);
}

/// Distances from similarities and the weighted original distances, by definition; not symmetrized.
DistanceMatrix with_original(const Eigen::MatrixXd& similarities, const DistanceMatrix& distances, std::size_t k,
                             double tie) {
  const Eigen::Index n = distances.rows();
  double sum = 0;
  double count = 0;
  Eigen::MatrixXd reach = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (const Eigen::Index j : nearest_of(distances, i, k)) {
      sum += distances(i, j);
      ++count;
      reach(i, j) = reach(j, i) = 1;
    }
  }
  for (Eigen::Index step = 0; step < n; ++step) reach = (reach * reach).cwiseSign().eval();
  DistanceMatrix result(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      double original = distances(i, j);
      if (std::isinf(original) && reach(i, j) > 0) original = largest_finite(distances);
      result(i, j) = i == j ? 0 : 1 - similarities(i, j) + tie * original / (sum / count);
    }
  }
  return result;
}

/// Diffusion by its definition, literally; not made symmetric.
DistanceMatrix diffusion_reference(const DistanceMatrix& distances, std::size_t k, double damping, double tie) {
  return with_original((1 - damping) * affinity_reference(distances, k, damping), distances, k, tie);
}

/// Mean over several k of the normalized affinities, by definition; not symmetrized.
DistanceMatrix averaged_reference(const DistanceMatrix& distances, const std::vector<std::size_t>& counts,
                                  double damping, double tie) {
  Eigen::MatrixXd similarities = Eigen::MatrixXd::Zero(distances.rows(), distances.cols());
  for (const std::size_t k : counts) {
    const Eigen::MatrixXd f = affinity_reference(distances, k, damping);
    for (Eigen::Index i = 0; i < f.rows(); ++i) {
      for (Eigen::Index j = 0; j < f.cols(); ++j) {
        similarities(i, j) += f(i, j) / std::sqrt(f(i, i) * f(j, j)) / static_cast<double>(counts.size());
      }
    }
  }
  return with_original(similarities, distances, std::ranges::max(counts), tie);
}

TEST(Diffusion, MatchesADirectImplementation) {
  const DistanceMatrix distances = distances_of(arcs(15, 3, 1));
  const DistanceMatrix expected = diffusion_reference(distances, 6, 0.9, 0.01);
  const DistanceMatrix found = diffused(distances, {.neighbours = 6, .damping = 0.9, .tie = 0.01});
  EXPECT_LT(largest_difference(found, (expected + expected.transpose()) / 2), 1e-9);
}

TEST(Diffusion, DistancesEqualACalculationWithTheEigenLibrary) {
  for (const Eigen::Index size : {1, 3, 31, 32, 65, 129, 300, 517}) {
    const DistanceMatrix distances = distances_of(arcs(size, 1, 1));
    const DiffusionOptions options{.neighbours = 5, .tie = 0};
    const Eigen::MatrixXd graph = diffusion_graph(nearest_models(size, 5, rows_of(distances)), 5);
    const Eigen::MatrixXd affinities = inverse_of(Eigen::MatrixXd::Identity(size, size) - options.damping * graph);
    const DistanceMatrix walked = 1 - (1 - options.damping) * affinities.array();
    DistanceMatrix expected = walked / 2 + walked.transpose() / 2;
    expected.diagonal().setZero();
    EXPECT_EQ(diffused(distances, options), expected) << size;
  }
}

TEST(Diffusion, MatchesADirectImplementationWithInfiniteDistances) {
  const DistanceMatrix distances = with_gaps(distances_of(arcs(20, 3, 1)));
  const DistanceMatrix expected = diffusion_reference(distances, 6, 0.9, 0.01);
  const DiffusionOptions options{.neighbours = 6, .damping = 0.9, .tie = 0.01};
  expect_near(diffused(distances, options), mean_with_transposed(expected), 1e-9);
  expect_near(diffused_by_rows(distances, options), expected, 2e-6);
  const auto infinite = (expected.array() == no_neighbour).count();
  EXPECT_GT(infinite, 2 * 59);                                       // the model 7, and between the halves
  EXPECT_LT(infinite, (distances.array() == no_neighbour).count());  // walks connect some
}

TEST(Diffusion, SparseRowSolverMatchesTheDenseSolution) {
  const DistanceMatrix distances = distances_of(arcs(100, 3, 2));  // more than one block of rows
  const DistanceMatrix by_rows = diffused_by_rows(distances);
  const DistanceMatrix symmetric = (by_rows + by_rows.transpose()) / 2;
  // The tolerance of the iteration.
  EXPECT_LT(largest_difference(symmetric, diffused(distances)), 2e-6);
}

TEST(Diffusion, ImprovesTheFirstTierForClassesOfPointsOnArcs) {
  const DistanceMatrix distances = distances_of(arcs(60, 3, 3));
  EXPECT_LT(first_tier(distances, 60), 0.5);
  EXPECT_GT(first_tier(diffused(distances, {.neighbours = 6, .damping = 0.99}), 60), 0.7);
}

TEST(Diffusion, OrdersModelsWithoutAffinityByOriginalDistance) {
  // Two groups too far apart for any affinity between them.
  Eigen::MatrixXd points = arcs(20, 2, 4);
  points.bottomRows(20).array() += 1000;
  const DistanceMatrix distances = distances_of(points);
  const DistanceMatrix found = diffused(distances, {.neighbours = 5});
  for (Eigen::Index j = 20; j + 1 < 40; ++j) {
    EXPECT_EQ(distances(0, j) < distances(0, j + 1), found(0, j) < found(0, j + 1));
    EXPECT_GT(found(0, j), found.row(0).head(20).maxCoeff());
  }
}

TEST(AveragedDiffusion, MatchesADirectImplementation) {
  const DistanceMatrix plain = distances_of(arcs(20, 3, 1));
  for (const DistanceMatrix& distances : {plain, with_gaps(plain)}) {
    const DistanceMatrix expected = averaged_reference(distances, {4, 6, 11}, 0.9, 0.01);
    const DiffusionOptions options{.neighbours = {6, 11, 4}, .damping = 0.9, .tie = 0.01};
    expect_near(diffused(distances, options), mean_with_transposed(expected), 1e-9);
    expect_near(diffused_by_rows(distances, options), expected, 2e-6);
  }
}

TEST(AveragedDiffusion, AveragesSixNeighbourCountsFromFourToTwentyByDefault) {
  const DistanceMatrix distances = distances_of(arcs(25, 3, 2));
  const DistanceMatrix automatic = diffused(distances, {.neighbours = {}});
  EXPECT_EQ(automatic, diffused(distances, {.neighbours = {4, 5, 7, 10, 14, 20}}));
  EXPECT_EQ(automatic, diffused(distances, {.neighbours = {20, 4, 14, 5, 10, 7}}));
}

TEST(AveragedDiffusion, DoesNotWorsenRetrievalForClassesOfAnySize) {
  for (const Eigen::Index per_class : {4, 8, 25}) {
    const DistanceMatrix distances = distances_of(clusters(per_class, 12, 3));
    EXPECT_GE(first_tier(diffused(distances, {.neighbours = {}}), per_class), first_tier(distances, per_class));
  }
}

TEST(DiffusedDiagonal, MatchesTheDiagonalOfTheInvertedDiffusionMatrix) {
  const DistanceMatrix distances = distances_of(arcs(40, 3, 5));
  for (const double damping : {0.0, 0.3, 0.95}) {
    const auto graph = diffusion_graph(nearest_models(120, 7, rows_of(distances)), 7);
    const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(120, 120) - damping * Eigen::MatrixXd(graph);
    const Eigen::VectorXd expected = inverse_of(system).diagonal();
    // The tolerance of the series and of the row solver.
    EXPECT_LT((diffused_diagonal(graph, damping) - expected).cwiseAbs().maxCoeff(), 2e-6 * expected.maxCoeff())
        << damping;
  }
}

/// Expected result of diffused_nearest(): the first of the query's sorted row.
std::vector<RankedModel> nearest_in_row(const DistanceMatrix& distances, Eigen::Index query, std::size_t count) {
  std::vector<RankedModel> models;
  for (Eigen::Index j = 0; j < distances.cols(); ++j) {
    if (j != query) models.push_back({j, distances(query, j)});
  }
  std::ranges::stable_sort(models, {}, &RankedModel::distance);
  models.resize(std::min(models.size(), count));
  return models;
}

void expect_same_answer(const std::vector<RankedModel>& found, const std::vector<RankedModel>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].distance, expected[i].distance, 1e-5) << i;
    const bool tied = i + 1 < expected.size() && expected[i + 1].distance - expected[i].distance < 1e-5;
    const bool tied_before = i > 0 && expected[i].distance - expected[i - 1].distance < 1e-5;
    if (tied || tied_before) continue;
    EXPECT_EQ(found[i].model, expected[i].model) << i;
  }
}

TEST(DiffusedNearestModels, EqualTheFirstModelsOfTheSortedDiffusedRow) {
  const DistanceMatrix distances = distances_of(arcs(20, 4, 3));
  for (const IntegerList& neighbours : {IntegerList{7}, IntegerList{}, IntegerList{4, 9}}) {
    const DiffusionOptions options{.neighbours = neighbours};
    const DistanceMatrix whole = diffused(distances, options);
    const NearestModels nearest =
        nearest_models(distances.rows(), neighbour_counts(neighbours).back(), rows_of(distances));
    for (const Eigen::Index query : {0, 33, 79}) {
      for (const std::size_t count : {std::size_t{1}, std::size_t{10}, std::size_t{100}}) {
        SCOPED_TRACE(testing::Message() << query << " of " << neighbour_counts(neighbours).size() << ", " << count);
        expect_same_answer(diffused_nearest(nearest, query, distances.row(query), options, count),
                           nearest_in_row(whole, query, count));
      }
    }
    EXPECT_TRUE(diffused_nearest(nearest, 0, distances.row(0), options, 0).empty());
  }
}

TEST(KeepNearestOption, PutsTheOriginallyNearestModelFirstAndChangesNoOtherDistance) {
  const DistanceMatrix distances = distances_of(arcs(20, 4, 3));
  const DiffusionOptions plain{.neighbours = {}};
  const DiffusionOptions keeping{.neighbours = {}, .keep_nearest = true};
  const NearestModels nearest = nearest_models(80, 20, rows_of(distances));
  const DistanceMatrix moved = diffused(distances, plain);
  const DistanceMatrix nearest_first = diffused(distances, keeping);
  int changed = 0;
  for (Eigen::Index i = 0; i < 80; ++i) {
    const std::int32_t first = nearest.indices(i, 0);
    EXPECT_EQ(nearest_in_row(nearest_first, i, 1).front().model, first);
    for (Eigen::Index j = 0; j < 80; ++j) {
      if (j != first) {
        EXPECT_EQ(nearest_first(i, j), moved(i, j));
      }
    }
    EXPECT_LE(nearest_first(i, first), moved(i, first));
    changed += nearest_first(i, first) < moved(i, first) ? 1 : 0;
    for (const std::size_t count : {std::size_t{1}, std::size_t{10}}) {
      expect_same_answer(diffused_nearest(nearest, i, distances.row(i), keeping, count),
                         nearest_in_row(nearest_first, i, count));
    }
  }
  EXPECT_GT(changed, 0);
  EXPECT_LT(largest_difference(diffused_by_rows(distances, keeping), nearest_first), 2e-6);
}

/// With such a damping, errors of the solver make many distances negative.
TEST(KeepNearestOption, NearestModelStaysFirstIfDiffusedDistancesAreNegative) {
  const DistanceMatrix distances = distances_of(arcs(10, 4, 3));
  const DistanceMatrix nearest_first =
      diffused_by_rows(distances, {.neighbours = {}, .damping = 0.999999, .tie = 0, .keep_nearest = true});
  for (Eigen::Index i = 0; i < 40; ++i) {
    EXPECT_EQ(nearest_in_row(nearest_first, i, 1).front().model, nearest_in_row(distances, i, 1).front().model);
  }
}

TEST(NearestModelsWithQuery, AppendedQueryGivesTheNearestModelsOfTheExtendedCollection) {
  for (const Eigen::Index models : {1, 3, 6, 40}) {
    Eigen::MatrixXd points = clusters(models + 1, 1, 8);
    if (models > 3) points.row(2) = points.row(models);  // at distance 0 from the last
    const DistanceMatrix all = distances_of(points);
    const DistanceMatrix before = all.topLeftCorner(models, models);
    for (const int k : {1, 5, 20}) {
      const NearestModels expected = nearest_models(models + 1, k, rows_of(all));
      const NearestModels found =
          append_query(nearest_models(models, k, rows_of(before)), all.row(models).head(models), k);
      EXPECT_EQ(found.indices, expected.indices) << models << ", " << k;
      EXPECT_EQ(found.distances, expected.distances) << models << ", " << k;
      EXPECT_EQ(found.largest, expected.largest);
    }
  }
}

}  // namespace

}  // namespace shapegauge

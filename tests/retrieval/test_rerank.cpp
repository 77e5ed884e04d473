#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tbb/task_arena.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {
namespace {

/// Points in a plane: classes along curves, so that their ends are far apart and classes near.
Eigen::MatrixXd arcs(Eigen::Index per_class, Eigen::Index classes, std::uint64_t seed) {
  RandomNumbers random(seed);
  Eigen::MatrixXd points(per_class * classes, 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double radius = 1 + 0.5 * static_cast<double>(i / per_class) + random.uniform(-0.05, 0.05);
    const double angle = random.uniform(0, 3);
    points.row(i) << radius * std::cos(angle), radius * std::sin(angle);
  }
  return points;
}

/// Points about centres, in more dimensions than a neighbourhood shows.
Eigen::MatrixXd clusters(Eigen::Index per_class, Eigen::Index classes, std::uint64_t seed) {
  RandomNumbers random(seed);
  const Eigen::Index dimensions = 20;
  const Eigen::MatrixXd centres =
      Eigen::MatrixXd::NullaryExpr(classes, dimensions, [&] { return random.uniform(-1, 1); });
  return Eigen::MatrixXd::NullaryExpr(per_class * classes, dimensions, [&](Eigen::Index i, Eigen::Index k) {
    return centres(i / per_class, k) + random.uniform(-1.2, 1.2);
  });
}

DistanceMatrix distances_of(const Eigen::MatrixXd& points) {
  DistanceMatrix matrix(points.rows(), points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    matrix.row(i) = (points.rowwise() - points.row(i)).rowwise().norm().transpose();
  }
  return matrix;
}

/// Share of the nearest that are of the same class, over all ranks that could be.
double first_tier(const DistanceMatrix& distances, Eigen::Index per_class) {
  double hits = 0;
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(distances.cols()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    order.erase(order.begin() + i);
    std::ranges::stable_sort(order, {}, [&](Eigen::Index j) { return distances(i, j); });
    for (Eigen::Index k = 0; k + 1 < per_class; ++k) {
      hits += order[static_cast<std::size_t>(k)] / per_class == i / per_class ? 1 : 0;
    }
  }
  return hits / static_cast<double>(distances.rows() * (per_class - 1));
}

double largest_difference(const DistanceMatrix& a, const DistanceMatrix& b) {
  EXPECT_EQ(a.rows(), b.rows());
  return (a - b).lpNorm<Eigen::Infinity>();
}

RowSource rows_of(const DistanceMatrix& matrix) {
  return
      [&matrix](Eigen::Index first, Eigen::Index count) -> DistanceMatrix { return matrix.middleRows(first, count); };
}

DistanceMatrix diffused_by_rows(const DistanceMatrix& matrix, const DiffusionOptions& options = {}) {
  DistanceMatrix result(matrix.rows(), matrix.cols());
  diffuse(matrix.rows(), rows_of(matrix), options,
          [&](Eigen::Index first, const DistanceMatrix& rows) { result.middleRows(first, rows.rows()) = rows; });
  return result;
}

/// The definition, literally.
DistanceMatrix diffusion_reference(const DistanceMatrix& distances, int k, double damping, double tie) {
  const Eigen::Index n = distances.rows();
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(n, n);
  std::vector<std::vector<Eigen::Index>> nearest;
  Eigen::VectorXd s = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    order.erase(order.begin() + i);
    std::ranges::stable_sort(order, {}, [&](Eigen::Index j) { return distances(i, j); });
    order.resize(static_cast<std::size_t>(k));
    for (const Eigen::Index j : order) s[i] += distances(i, j) / k;
    nearest.push_back(order);
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    for (const Eigen::Index j : nearest[static_cast<std::size_t>(i)]) {
      w(i, j) = std::exp(-distances(i, j) * distances(i, j) / (s[i] * s[j]));
    }
  }
  const Eigen::MatrixXd a = (w + w.transpose()) / 2;
  const Eigen::VectorXd degrees = a.rowwise().sum();
  DistanceMatrix result(n, n);
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) system(i, j) -= damping * a(i, j) / std::sqrt(degrees[i] * degrees[j]);
  }
  const Eigen::MatrixXd f = system.inverse();
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      result(i, j) = i == j ? 0 : 1 - (1 - damping) * f(i, j) + tie * distances(i, j) / s.mean();
    }
  }
  return result;
}

TEST(Diffusion, IsWhatTheDefinitionSays) {
  const DistanceMatrix distances = distances_of(arcs(15, 3, 1));
  const DistanceMatrix expected = diffusion_reference(distances, 6, 0.9, 0.01);
  const DistanceMatrix found = diffused(distances, {.neighbours = 6, .damping = 0.9, .tie = 0.01});
  EXPECT_LT(largest_difference(found, (expected + expected.transpose()) / 2), 1e-9);
}

TEST(Diffusion, RowsFromTheSparseSystemAreThoseOfTheDenseOne) {
  const DistanceMatrix distances = distances_of(arcs(100, 3, 2));  // more than one block of rows
  const DistanceMatrix by_rows = diffused_by_rows(distances);
  const DistanceMatrix symmetric = (by_rows + by_rows.transpose()) / 2;
  // The tolerance of the iteration.
  EXPECT_LT(largest_difference(symmetric, diffused(distances)), 2e-6);
}

TEST(Diffusion, FollowsCurvesThatDistancesCut) {
  const DistanceMatrix distances = distances_of(arcs(60, 3, 3));
  EXPECT_LT(first_tier(distances, 60), 0.5);
  EXPECT_GT(first_tier(diffused(distances, {.neighbours = 6, .damping = 0.99}), 60), 0.7);
}

TEST(Diffusion, TiesKeepTheOriginalOrder) {
  // Two groups so far apart that nothing goes from one to the other.
  Eigen::MatrixXd points = arcs(20, 2, 4);
  points.bottomRows(20).array() += 1000;
  const DistanceMatrix distances = distances_of(points);
  const DistanceMatrix found = diffused(distances, {.neighbours = 5});
  for (Eigen::Index j = 20; j + 1 < 40; ++j) {
    EXPECT_EQ(distances(0, j) < distances(0, j + 1), found(0, j) < found(0, j + 1));
    EXPECT_GT(found(0, j), found.row(0).head(20).maxCoeff());
  }
}

struct Method {
  const char* name;
  DistanceMatrix (*rerank)(const DistanceMatrix&);
};

class Reranking : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(
    All, Reranking,
    testing::Values(Method{"diffusion", [](const DistanceMatrix& d) { return diffused(d); }},
                    Method{"diffusion_by_rows", [](const DistanceMatrix& d) { return diffused_by_rows(d); }},
                    Method{"k_reciprocal", [](const DistanceMatrix& d) { return k_reciprocal(d); }},
                    Method{"query_expansion", [](const DistanceMatrix& d) { return query_expansion(d); }}),
    [](const auto& method) { return std::string(method.param.name); });

TEST_P(Reranking, PermutedModelsHavePermutedDistances) {
  const Eigen::MatrixXd points = arcs(25, 3, 5);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(points.rows()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  RandomNumbers random(1);
  for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
  const DistanceMatrix expected = GetParam().rerank(distances_of(points));
  const DistanceMatrix found = GetParam().rerank(distances_of(points(order, Eigen::all)));
  EXPECT_LT(largest_difference(found, expected(order, order)), 2e-6);
}

TEST_P(Reranking, ImprovesClassesAndTheScaleDoesNotMatter) {
  const DistanceMatrix distances = distances_of(clusters(20, 5, 6));
  const DistanceMatrix found = GetParam().rerank(distances);
  EXPECT_GT(first_tier(found, 20), first_tier(distances, 20));
  EXPECT_EQ(first_tier(GetParam().rerank(4 * distances), 20), first_tier(found, 20));
}

TEST_P(Reranking, SameBytesOnAnyNumberOfThreads) {
  const DistanceMatrix distances = distances_of(arcs(40, 3, 7));
  const auto on = [&](int threads) {
    tbb::task_arena arena(threads);
    return arena.execute([&] { return GetParam().rerank(distances); });
  };
  const DistanceMatrix one = on(1);
  const DistanceMatrix four = on(4);
  EXPECT_EQ(std::memcmp(one.data(), four.data(), sizeof(double) * static_cast<std::size_t>(one.size())), 0);
}

TEST_P(Reranking, FewModelsAndEqualOnesAreNoTrouble) {
  for (const Eigen::Index size : {1, 2, 3}) {
    const DistanceMatrix found = GetParam().rerank(distances_of(arcs(size, 1, 1)));
    EXPECT_EQ(found.rows(), size);
    EXPECT_TRUE(found.allFinite());
    EXPECT_EQ(found.diagonal().cwiseAbs().maxCoeff(), 0);
  }
  EXPECT_TRUE(GetParam().rerank(DistanceMatrix::Zero(30, 30)).allFinite());
}

TEST_P(Reranking, RefusesDistancesThatAreNone) {
  DistanceMatrix distances = distances_of(arcs(5, 2, 1));
  distances(2, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(GetParam().rerank(distances), std::invalid_argument);
  distances(2, 3) = -1;
  EXPECT_THROW(GetParam().rerank(distances), std::invalid_argument);
}

TEST(NearestModels, AreInOrderAndTheLesserIndexFirst) {
  DistanceMatrix distances(4, 4);
  distances << 0, 2, 1, 2, 2, 0, 3, 1, 1, 3, 0, 3, 2, 1, 3, 0;
  const NearestModels nearest = nearest_models(4, 2, rows_of(distances));
  EXPECT_EQ(nearest.indices.row(0), (Eigen::RowVector2i{2, 1}));
  EXPECT_EQ(nearest.indices.row(1), (Eigen::RowVector2i{3, 0}));
  EXPECT_EQ(nearest.distances(2, 1), 3);
  EXPECT_EQ(nearest.indices(2, 1), 1);
}

TEST(KReciprocal, NeighboursOfEachOtherAreNearerThanOthers) {
  // 0 to 3 are near each other; 4 is nearer to 3 than 0 is, but has nearer neighbours of its own.
  const std::vector<double> places = {0, 1, 2, 3, 5.5, 5.6, 5.7, 5.8};
  Eigen::MatrixXd points(8, 1);
  for (std::size_t i = 0; i < places.size(); ++i) points(static_cast<Eigen::Index>(i), 0) = places[i];
  const DistanceMatrix distances = distances_of(points);
  ASSERT_LT(distances(3, 4), distances(3, 0));
  const DistanceMatrix found = k_reciprocal(distances, {.neighbours = 3, .expansion_neighbours = 2, .original = 0});
  EXPECT_GT(found(3, 4), found(3, 0));
  EXPECT_NEAR(found(3, 4), 1, 1e-12);
}

TEST(QueryExpansion, IsTheWeightedMeanOfRows) {
  Eigen::MatrixXd points(3, 1);
  points << 0, 1, 3;
  // Rows with their nearest: (0 1 3) + (1 0 2) / 2, over 1.5; (1 0 2) + (0 1 3) / 2; (3 2 0) + (1 0 2) / 2.
  const DistanceMatrix found = query_expansion(distances_of(points), {.neighbours = 1});
  EXPECT_NEAR(found(0, 1), ((1 + 0.0) / 1.5 + (1 + 0.0) / 1.5) / 2, 1e-15);
  EXPECT_NEAR(found(0, 2), ((3 + 1.0) / 1.5 + (3 + 0.5) / 1.5) / 2, 1e-15);
}

TEST(Rerank, RefusesOptionsOutOfRange) {
  const DistanceMatrix distances = distances_of(arcs(5, 2, 1));
  EXPECT_THROW(diffused(distances, {.neighbours = 0}), InputError);
  EXPECT_THROW(diffused(distances, {.damping = 1}), InputError);
  EXPECT_THROW(diffused(distances, {.tie = -1}), InputError);
  EXPECT_THROW(k_reciprocal(distances, {.neighbours = 4, .expansion_neighbours = 5}), InputError);
  EXPECT_THROW(k_reciprocal(distances, {.original = 2}), InputError);
  EXPECT_THROW(query_expansion(distances, {.neighbours = 0}), InputError);
  EXPECT_THROW(diffused(distances.leftCols(4)), std::invalid_argument);
}

}  // namespace
}  // namespace shapegauge

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <set>
#include <string_view>
#include <tbb/task_arena.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/diffusion.h"
#include "shapegauge/retrieval/k_reciprocal.h"
#include "shapegauge/retrieval/query_expansion.h"
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

DistanceMatrix diffused_by_rows(const DistanceMatrix& matrix, const DiffusionOptions& options = {}) {
  DistanceMatrix result(matrix.rows(), matrix.cols());
  diffuse(matrix.rows(), rows_of(matrix), options,
          [&](Eigen::Index first, const DistanceMatrix& rows) { result.middleRows(first, rows.rows()) = rows; });
  return result;
}

constexpr double no_neighbour = std::numeric_limits<double>::infinity();

/// The k nearest others at a finite distance, or as many as there are.
std::vector<Eigen::Index> nearest_of(const DistanceMatrix& distances, Eigen::Index model, std::size_t k) {
  std::vector<Eigen::Index> order;
  for (Eigen::Index j = 0; j < distances.cols(); ++j) {
    if (j != model && std::isfinite(distances(model, j))) order.push_back(j);
  }
  std::ranges::stable_sort(order, {}, [&](Eigen::Index j) { return distances(model, j); });
  order.resize(std::min(k, order.size()));
  return order;
}

double largest_finite(const DistanceMatrix& distances) {
  return distances.array().isFinite().select(distances, 0).maxCoeff();
}

DistanceMatrix mean_with_transposed(const DistanceMatrix& distances) {
  DistanceMatrix result = (distances + distances.transpose()) / 2;
  result.diagonal().setZero();
  return result;
}

/// Diffusion by its definition, literally; not made symmetric.
DistanceMatrix diffusion_reference(const DistanceMatrix& distances, std::size_t k, double damping, double tie) {
  const Eigen::Index n = distances.rows();
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd s = Eigen::VectorXd::Zero(n);
  double sum = 0;
  double count = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::vector<Eigen::Index> nearest = nearest_of(distances, i, k);
    for (const Eigen::Index j : nearest) s[i] += distances(i, j) / static_cast<double>(nearest.size());
    for (const Eigen::Index j : nearest) sum += distances(i, j);
    count += static_cast<double>(nearest.size());
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    for (const Eigen::Index j : nearest_of(distances, i, k)) {
      w(i, j) = std::exp(-distances(i, j) * distances(i, j) / (s[i] * s[j]));
    }
  }
  const Eigen::MatrixXd a = (w + w.transpose()) / 2;
  const Eigen::VectorXd degrees = a.rowwise().sum();
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd reach = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      if (a(i, j) > 0) system(i, j) -= damping * a(i, j) / std::sqrt(degrees[i] * degrees[j]);
    }
  }
  for (Eigen::Index step = 0; step < n; ++step) reach = (reach + reach * a).cwiseSign().eval();
  const Eigen::MatrixXd f = system.inverse();
  DistanceMatrix result(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      double original = distances(i, j);
      if (std::isinf(original) && reach(i, j) > 0) original = largest_finite(distances);
      result(i, j) = i == j ? 0 : 1 - (1 - damping) * f(i, j) + tie * original / (sum / count);
    }
  }
  return result;
}

using ModelSet = std::set<Eigen::Index>;

/// The model and its neighbours among the k nearest that have it among theirs.
ModelSet reciprocal_set(const DistanceMatrix& distances, Eigen::Index model, std::size_t k) {
  ModelSet found = {model};
  for (const Eigen::Index other : nearest_of(distances, model, k)) {
    const std::vector<Eigen::Index> theirs = nearest_of(distances, other, k);
    if (std::ranges::find(theirs, model) != theirs.end()) found.insert(other);
  }
  return found;
}

/// k-reciprocal re-ranking by its definition (Zhong et al. 2017, equations 2 to 12), literally, with dense vectors.
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

/// Query expansion by its definition, literally.
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

/// The distances with two thirds of the pairs infinite, all of those of the model 7 and those between two halves.
DistanceMatrix with_gaps(DistanceMatrix distances) {
  RandomNumbers random(11);
  const Eigen::Index half = distances.rows() / 2;
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      if (i == 7 || j == 7 || (i < half) != (j < half) || random.uniform(0, 1) < 0.3) {
        distances(i, j) = distances(j, i) = no_neighbour;
      }
    }
  }
  return distances;
}

/// Expects the same entries to be infinite and the others to be equal within the tolerance.
void expect_near(const DistanceMatrix& found, const DistanceMatrix& expected, double tolerance) {
  ASSERT_EQ(found.rows(), expected.rows());
  for (Eigen::Index i = 0; i < found.rows(); ++i) {
    for (Eigen::Index j = 0; j < found.cols(); ++j) {
      if (found(i, j) == expected(i, j)) continue;
      ASSERT_LE(std::abs(found(i, j) - expected(i, j)), tolerance) << i << " " << j << " " << found(i, j);
      ASSERT_TRUE(std::isfinite(found(i, j))) << i << " " << j;
    }
  }
}

TEST(Diffusion, IsWhatTheDefinitionSays) {
  const DistanceMatrix distances = distances_of(arcs(15, 3, 1));
  const DistanceMatrix expected = diffusion_reference(distances, 6, 0.9, 0.01);
  const DistanceMatrix found = diffused(distances, {.neighbours = 6, .damping = 0.9, .tie = 0.01});
  EXPECT_LT(largest_difference(found, (expected + expected.transpose()) / 2), 1e-9);
}

TEST(Diffusion, InvertsToTheBitAsEigen) {
  for (const Eigen::Index size : {1, 3, 31, 32, 65, 129, 300, 517}) {
    const DistanceMatrix distances = distances_of(arcs(size, 1, 1));
    const DiffusionOptions options{.neighbours = 5, .tie = 0};
    const Eigen::MatrixXd graph = diffusion_graph(nearest_models(size, 5, rows_of(distances)), options);
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(size, size);
    const Eigen::MatrixXd affinities = (identity - options.damping * graph).llt().solve(identity);
    const DistanceMatrix walked = 1 - (1 - options.damping) * affinities.array();
    DistanceMatrix expected = walked / 2 + walked.transpose() / 2;
    expected.diagonal().setZero();
    EXPECT_EQ(diffused(distances, options), expected) << size;
  }
}

TEST(Diffusion, OfInfiniteDistancesIsWhatTheDefinitionSays) {
  const DistanceMatrix distances = with_gaps(distances_of(arcs(20, 3, 1)));
  const DistanceMatrix expected = diffusion_reference(distances, 6, 0.9, 0.01);
  const DiffusionOptions options{.neighbours = 6, .damping = 0.9, .tie = 0.01};
  expect_near(diffused(distances, options), mean_with_transposed(expected), 1e-9);
  expect_near(diffused_by_rows(distances, options), expected, 2e-6);
  const auto infinite = (expected.array() == no_neighbour).count();
  EXPECT_GT(infinite, 2 * 59);                                       // the model 7, and between the halves
  EXPECT_LT(infinite, (distances.array() == no_neighbour).count());  // walks join some
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

/// The distances with a model in front that is at an infinite distance from all.
DistanceMatrix with_isolated_model(const DistanceMatrix& distances) {
  DistanceMatrix result = DistanceMatrix::Constant(distances.rows() + 1, distances.cols() + 1, no_neighbour);
  result(0, 0) = 0;
  result.bottomRightCorner(distances.rows(), distances.cols()) = distances;
  return result;
}

TEST_P(Reranking, AModelWithoutNeighboursStaysSoAndChangesNothingForTheOthers) {
  const DistanceMatrix distances = distances_of(arcs(25, 3, 5));
  const DistanceMatrix expected = with_isolated_model(GetParam().rerank(distances));
  expect_near(GetParam().rerank(with_isolated_model(distances)), expected, 2e-6);
  const DistanceMatrix nothing = DistanceMatrix::Constant(5, 5, no_neighbour);
  DistanceMatrix all_isolated = nothing;
  all_isolated.diagonal().setZero();
  EXPECT_EQ(GetParam().rerank(nothing), all_isolated);
}

TEST_P(Reranking, HugeAndTinyDistancesAreLikeOthers) {
  const DistanceMatrix distances = distances_of(arcs(25, 3, 5));
  const DistanceMatrix expected = GetParam().rerank(distances);
  const bool has_unit = std::string_view(GetParam().name) == "query_expansion";
  for (const double factor : {1e300, 1.7e308 / distances.maxCoeff(), 1e-300, 1e-305}) {
    const DistanceMatrix found = GetParam().rerank(distances * factor) / (has_unit ? factor : 1);
    EXPECT_LT(largest_difference(found, expected), 2e-6) << factor;
  }
}

TEST_P(Reranking, OneFarModelLeavesAllDistancesFinite) {
  for (const double far : {1e154, 1e200, 1e308, std::numeric_limits<double>::max()}) {
    DistanceMatrix distances = distances_of(arcs(10, 3, 5));
    distances.row(4).setConstant(far);
    distances.col(4).setConstant(far);
    distances(4, 4) = 0;
    const DistanceMatrix found = GetParam().rerank(distances);
    EXPECT_TRUE(found.allFinite()) << far;
    EXPECT_GE(found.minCoeff(), 0) << far;
  }
}

TEST_P(Reranking, TheDiagonalPlaysNoPart) {
  DistanceMatrix distances = distances_of(arcs(10, 3, 5));
  const DistanceMatrix expected = GetParam().rerank(distances);
  for (const double own : {no_neighbour, 1e308, 0.5}) {
    distances.diagonal().setConstant(own);
    EXPECT_EQ(GetParam().rerank(distances), expected) << own;
  }
}

TEST_P(Reranking, RefusesDistancesThatAreNone) {
  DistanceMatrix distances = distances_of(arcs(5, 2, 1));
  distances(2, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(GetParam().rerank(distances), ArgumentError);
  distances(2, 3) = -1;
  EXPECT_THROW(GetParam().rerank(distances), ArgumentError);
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

TEST(KReciprocal, IsWhatTheDefinitionSays) {
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

TEST(QueryExpansion, IsWhatTheDefinitionSays) {
  const DistanceMatrix plain = distances_of(arcs(15, 3, 1));
  for (const DistanceMatrix& distances : {plain, with_gaps(plain)}) {
    expect_near(query_expansion(distances, {.neighbours = 4}), expansion_reference(distances, 4), 1e-12);
  }
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
  EXPECT_THROW(diffused(distances.leftCols(4)), ArgumentError);
}

}  // namespace
}  // namespace shapegauge

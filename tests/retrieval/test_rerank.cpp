// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <string_view>
#include <tbb/task_arena.h>
#include <vector>

#include "shapegauge/core/base/cancellation.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/retrieval/diffusion.h"
#include "shapegauge/retrieval/k_reciprocal.h"
#include "shapegauge/retrieval/query_expansion.h"
#include "shapegauge/retrieval/rerank.h"
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
using test::no_neighbour;
using test::random_order;

struct Method {
  const char* name;
  DistanceMatrix (*rerank)(const DistanceMatrix&);
};

class EachRerankMethod : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(
    All, EachRerankMethod,
    testing::Values(
        Method{"diffusion", [](const DistanceMatrix& d) { return diffused(d); }},
        Method{"diffusion_by_rows", [](const DistanceMatrix& d) { return diffused_by_rows(d); }},
        Method{"k_reciprocal", [](const DistanceMatrix& d) { return k_reciprocal(d); }},
        Method{"query_expansion", [](const DistanceMatrix& d) { return query_expansion(d); }},
        Method{"averaged_diffusion", [](const DistanceMatrix& d) { return diffused(d, {.neighbours = {}}); }},
        Method{"averaged_diffusion_by_rows",
               [](const DistanceMatrix& d) { return diffused_by_rows(d, {.neighbours = {}}); }},
        Method{"averaged_k_reciprocal", [](const DistanceMatrix& d) { return k_reciprocal(d, {.neighbours = {}}); }},
        Method{"averaged_query_expansion",
               [](const DistanceMatrix& d) { return query_expansion(d, {.neighbours = {}}); }}),
    [](const auto& method) { return std::string(method.param.name); });

TEST_P(EachRerankMethod, DistancesDoNotDependOnTheOrderOfModels) {
  const Eigen::MatrixXd points = arcs(25, 3, 5);
  const std::vector<Eigen::Index> order = random_order(points.rows(), 1);
  const DistanceMatrix expected = GetParam().rerank(distances_of(points));
  const DistanceMatrix found = GetParam().rerank(distances_of(points(order, Eigen::all)));
  EXPECT_LT(largest_difference(found, expected(order, order)), 2e-6);
}

TEST_P(EachRerankMethod, ImprovesRetrievalAtAnyScaleOfDistances) {
  const DistanceMatrix distances = distances_of(clusters(20, 5, 6));
  const DistanceMatrix found = GetParam().rerank(distances);
  EXPECT_GT(first_tier(found, 20), first_tier(distances, 20));
  EXPECT_EQ(first_tier(GetParam().rerank(4 * distances), 20), first_tier(found, 20));
}

TEST_P(EachRerankMethod, GivesTheSameResultOnAnyNumberOfThreads) {
  const DistanceMatrix distances = distances_of(arcs(40, 3, 7));
  const auto on = [&](int threads) {
    tbb::task_arena arena(threads);
    return arena.execute([&] { return GetParam().rerank(distances); });
  };
  const DistanceMatrix one = on(1);
  const DistanceMatrix four = on(4);
  EXPECT_EQ(std::memcmp(one.data(), four.data(), sizeof(double) * static_cast<std::size_t>(one.size())), 0);
}

TEST_P(EachRerankMethod, GivesFiniteDistancesForFewModelsAndForEqualModels) {
  for (const Eigen::Index size : {1, 2, 3}) {
    const DistanceMatrix found = GetParam().rerank(distances_of(arcs(size, 1, 1)));
    EXPECT_EQ(found.rows(), size);
    EXPECT_TRUE(found.allFinite());
    EXPECT_EQ(found.diagonal().cwiseAbs().maxCoeff(), 0);
  }
  EXPECT_TRUE(GetParam().rerank(DistanceMatrix::Zero(30, 30)).allFinite());
}

/// The distances, preceded by a model at infinite distance from all others.
DistanceMatrix with_isolated_model(const DistanceMatrix& distances) {
  DistanceMatrix result = DistanceMatrix::Constant(distances.rows() + 1, distances.cols() + 1, no_neighbour);
  result(0, 0) = 0;
  result.bottomRightCorner(distances.rows(), distances.cols()) = distances;
  return result;
}

TEST_P(EachRerankMethod, DistancesDoNotChangeIfAnIsolatedModelIsAdded) {
  const DistanceMatrix distances = distances_of(arcs(25, 3, 5));
  const DistanceMatrix expected = with_isolated_model(GetParam().rerank(distances));
  expect_near(GetParam().rerank(with_isolated_model(distances)), expected, 2e-6);
  const DistanceMatrix nothing = DistanceMatrix::Constant(5, 5, no_neighbour);
  DistanceMatrix all_isolated = nothing;
  all_isolated.diagonal().setZero();
  EXPECT_EQ(GetParam().rerank(nothing), all_isolated);
}

TEST_P(EachRerankMethod, GivesTheSameDistancesAtHugeAndTinyScales) {
  const DistanceMatrix distances = distances_of(arcs(25, 3, 5));
  const DistanceMatrix expected = GetParam().rerank(distances);
  const bool has_unit = std::string_view(GetParam().name).ends_with("query_expansion");
  for (const double factor : {1e300, 1.7e308 / distances.maxCoeff(), 1e-300, 1e-305}) {
    const DistanceMatrix found = GetParam().rerank(distances * factor) / (has_unit ? factor : 1);
    EXPECT_LT(largest_difference(found, expected), 2e-6) << factor;
  }
}

TEST_P(EachRerankMethod, KeepsDistancesFiniteWithOneFarModel) {
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

TEST_P(EachRerankMethod, IgnoresTheDiagonalOfTheDistanceMatrix) {
  DistanceMatrix distances = distances_of(arcs(10, 3, 5));
  const DistanceMatrix expected = GetParam().rerank(distances);
  for (const double diagonal : {no_neighbour, 1e308, 0.5}) {
    distances.diagonal().setConstant(diagonal);
    EXPECT_EQ(GetParam().rerank(distances), expected) << diagonal;
  }
}

TEST_P(EachRerankMethod, StopsIfTheComputationIsCancelled) {
  const DistanceMatrix distances = distances_of(arcs(40, 3, 7));
  Cancellation cancellation;
  EXPECT_THROW(cancellation.run([&] {
    cancellation.cancel();
    GetParam().rerank(distances);
    FAIL();
  }),
               Interrupted);
}

TEST_P(EachRerankMethod, RejectsNegativeAndNanDistances) {
  DistanceMatrix distances = distances_of(arcs(5, 2, 1));
  distances(2, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(GetParam().rerank(distances), ArgumentError);
  distances(2, 3) = -1;
  EXPECT_THROW(GetParam().rerank(distances), ArgumentError);
}

TEST(RerankMethods, RefuseAMethodWithoutAFunction) {
  EXPECT_THROW(rerank_methods().add({.name = "test_none", .description = "", .parameters = {}}), ArgumentError);
  EXPECT_EQ(rerank_methods().find("test_none"), nullptr);
}

TEST(Rerank, RefusesOptionsOutOfRange) {
  const DistanceMatrix distances = distances_of(arcs(5, 2, 1));
  EXPECT_THROW(diffused(distances, {.neighbours = 0}), InputError);
  EXPECT_THROW(diffused(distances, {.neighbours = {4, 1001}}), InputError);
  EXPECT_THROW(diffused(distances, {.damping = 1}), InputError);
  EXPECT_THROW(diffused(distances, {.tie = -1}), InputError);
  EXPECT_THROW(k_reciprocal(distances, {.neighbours = 4, .expansion_neighbours = 5}), InputError);
  EXPECT_THROW(k_reciprocal(distances, {.neighbours = {3, 4}, .expansion_neighbours = 5}), InputError);
  EXPECT_THROW(k_reciprocal(distances, {.original = 2}), InputError);
  EXPECT_THROW(query_expansion(distances, {.neighbours = 0}), InputError);
  EXPECT_THROW(diffused(distances.leftCols(4)), ArgumentError);
}

}  // namespace

}  // namespace shapegauge

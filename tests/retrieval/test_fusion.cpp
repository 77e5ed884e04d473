#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/fusion.h"

namespace shapegauge {
namespace {

DistanceMatrix line_distances(const std::vector<double>& places) {
  const auto size = std::ssize(places);
  DistanceMatrix matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) {
      matrix(i, j) = std::abs(places[static_cast<std::size_t>(i)] - places[static_cast<std::size_t>(j)]);
    }
  }
  return matrix;
}

DistanceMatrix random_distances(Eigen::Index size, std::uint64_t seed) {
  RandomNumbers random(seed);
  DistanceMatrix matrix = DistanceMatrix::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) matrix(i, j) = matrix(j, i) = random.uniform(0, 1);
  }
  return matrix;
}

const std::vector<double> equal = {1, 1};

TEST(SumOfDistances, DividesByTheScaleAndMultipliesByTheWeight) {
  const DistanceMatrix a = line_distances({0, 1, 3});  // 1, 2, 3: median and mean 2
  const DistanceMatrix b = line_distances({0, 4, 6});  // 2, 4, 6: median and mean 4
  const std::vector both = {a, b};
  const std::vector<double> weights = {3, 2};
  EXPECT_EQ(sum_of_distances(both, weights, DistanceScale::none)(0, 1), 3 * 1 + 2 * 4);
  EXPECT_EQ(sum_of_distances(both, weights, DistanceScale::median)(0, 1), 3 * 0.5 + 2 * 1.0);
  EXPECT_EQ(sum_of_distances(both, weights, DistanceScale::mean)(0, 1), 3 * 0.5 + 2 * 1.0);
}

TEST(SumOfDistances, MedianAndMeanDiffer) {
  const std::vector one = {line_distances({0, 1, 11})};  // 1, 10, 11
  const std::vector<double> weight = {1};
  EXPECT_EQ(sum_of_distances(one, weight, DistanceScale::median)(0, 1), 0.1);
  EXPECT_NEAR(sum_of_distances(one, weight, DistanceScale::mean)(0, 1), 3.0 / 22, 1e-15);
}

TEST(SumOfDistances, DoesNotDependOnTheScaleOfAMatrix) {
  const DistanceMatrix a = random_distances(20, 1);
  const DistanceMatrix b = random_distances(20, 2);
  const std::vector plain = {a, b};
  const std::vector<DistanceMatrix> scaled = {a, 1024 * b};
  EXPECT_EQ(sum_of_distances(plain, equal), sum_of_distances(scaled, equal));
}

TEST(FusionOfRanks, ReciprocalRanksAsTheDefinitionSays) {
  const DistanceMatrix a = line_distances({0, 1, 3});
  const std::vector one = {a};
  const std::vector<double> weight = {1};
  const DistanceMatrix fused = fusion_of_ranks(one, weight, RankScore::reciprocal);
  // Of 0: 1, 2. Of 1: 0, 2. Of 2: 1, 0.
  EXPECT_EQ(fused(0, 1), 0);
  EXPECT_NEAR(fused(0, 2), 1 - 61.0 / 62, 1e-15);
  EXPECT_NEAR(fused(1, 2), 1 - (61.0 / 62 + 1) / 2, 1e-15);
  EXPECT_EQ(fused, DistanceMatrix(fused.transpose()));
}

TEST(FusionOfRanks, BordaCountsThoseBehind) {
  const DistanceMatrix a = line_distances({0, 1, 3});
  const DistanceMatrix b = line_distances({0, 3, 1});
  const std::vector both = {a, b};
  const DistanceMatrix fused = fusion_of_ranks(both, equal, RankScore::borda);
  // Ranks of (0, 1): 1 and 2; of (1, 0): 1 and 2. Scores 2 + 1 of 4 at most.
  EXPECT_NEAR(fused(0, 1), 1 - 3.0 / 4, 1e-15);
  // (1, 2): 2 and 1; (2, 1): 1 and 2.
  EXPECT_NEAR(fused(1, 2), 1 - 3.0 / 4, 1e-15);
}

TEST(FusionOfRanks, OnlyOrdersMatter) {
  const DistanceMatrix a = random_distances(30, 1);
  const DistanceMatrix b = random_distances(30, 2);
  const std::vector plain = {a, b};
  const std::vector<DistanceMatrix> bent = {a.cwiseAbs2(), b.cwiseSqrt()};
  for (const RankScore score : {RankScore::reciprocal, RankScore::borda}) {
    EXPECT_EQ(fusion_of_ranks(plain, equal, score), fusion_of_ranks(bent, equal, score));
  }
}

TEST(FusionOfRanks, AWeightOfZeroLeavesAMatrixOut) {
  const DistanceMatrix a = random_distances(30, 1);
  const DistanceMatrix b = random_distances(30, 2);
  const std::vector both = {a, b};
  const std::vector one = {a};
  const std::vector<double> first = {1, 0};
  const std::vector<double> weight = {1};
  EXPECT_EQ(fusion_of_ranks(both, first), fusion_of_ranks(one, weight));
  EXPECT_EQ(sum_of_distances(both, first), sum_of_distances(one, weight));
}

constexpr double unreachable = std::numeric_limits<double>::infinity();

TEST(SumOfDistances, InfiniteStaysInfiniteAndScalesAreOfTheOthers) {
  DistanceMatrix a = line_distances({0, 1, 3});
  DistanceMatrix b = line_distances({0, 4, 6});
  a(0, 2) = a(2, 0) = unreachable;  // 1 and 2 are left: median 2, mean 1.5
  const std::vector both = {a, b};
  const std::vector<double> weights = {3, 2};
  EXPECT_EQ(sum_of_distances(both, weights, DistanceScale::median)(0, 1), 3 * 0.5 + 2 * 1.0);
  EXPECT_NEAR(sum_of_distances(both, weights, DistanceScale::mean)(0, 1), 3 / 1.5 + 2 * 1.0, 1e-15);
  for (const DistanceScale scale : {DistanceScale::none, DistanceScale::median, DistanceScale::mean}) {
    const DistanceMatrix sum = sum_of_distances(both, weights, scale);
    EXPECT_EQ(sum(2, 0), unreachable);
    EXPECT_TRUE(std::isfinite(sum(1, 2)));
    EXPECT_TRUE(std::isfinite(sum_of_distances(both, std::vector<double>{0, 1}, scale)(2, 0)));
  }
}

TEST(SumOfDistances, HugeDistancesAreLikeOthers) {
  const DistanceMatrix a = random_distances(20, 1);
  const DistanceMatrix b = random_distances(20, 2);
  const std::vector plain = {a, b};
  const std::vector<DistanceMatrix> huge = {a, 1e308 * b};
  for (const DistanceScale scale : {DistanceScale::median, DistanceScale::mean}) {
    EXPECT_LT((sum_of_distances(plain, equal, scale) - sum_of_distances(huge, equal, scale)).cwiseAbs().maxCoeff(),
              1e-12);
  }
  const std::vector<DistanceMatrix> twice = {1.5e308 * a, 1.5e308 * a};
  EXPECT_TRUE(sum_of_distances(twice, equal, DistanceScale::none).allFinite());
}

TEST(FusionOfRanks, WhatNobodyRanksStaysInfinite) {
  DistanceMatrix a = line_distances({0, 1, 3, 4});
  const DistanceMatrix b = a;
  for (const Eigen::Index i : {0, 1, 2}) a(i, 3) = a(3, i) = unreachable;
  const std::vector<DistanceMatrix> alone = {a};
  const std::vector both = {a, b};
  for (const RankScore score : {RankScore::reciprocal, RankScore::borda}) {
    const DistanceMatrix fused = fusion_of_ranks(alone, std::vector<double>{1}, score);
    for (const Eigen::Index i : {0, 1, 2}) EXPECT_EQ(fused(3, i), unreachable);
    EXPECT_EQ(fused(0, 1), 0);
    EXPECT_EQ(fused(3, 3), 0);
    // Ranked by one of two: half of the score that both would give.
    const double with_both = 1 - fusion_of_ranks(both, equal, score)(2, 3);
    EXPECT_NEAR(2 * with_both, 1 - fusion_of_ranks(std::vector{b}, std::vector<double>{1}, score)(2, 3), 1e-12);
  }
}

TEST(Fusion, RefusesWhatCannotBeAdded) {
  const DistanceMatrix a = random_distances(5, 1);
  DistanceMatrix broken = a;
  broken(1, 2) = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::vector<DistanceMatrix>> unusable = {
      {}, {a}, {a, random_distances(6, 1)}, {a, DistanceMatrix::Zero(5, 4)}, {a, broken}, {a, -a}};
  for (const auto& matrices : unusable) {
    EXPECT_THROW(sum_of_distances(matrices, equal), ArgumentError);
    EXPECT_THROW(fusion_of_ranks(matrices, equal), ArgumentError);
  }
  const std::vector both = {a, a};
  for (const std::vector<double>& weights : {std::vector<double>{0, 0}, {1, -1}, {1}}) {
    EXPECT_THROW(sum_of_distances(both, weights), ArgumentError);
  }
  const std::vector<DistanceMatrix> zero = {a, DistanceMatrix::Zero(5, 5)};
  EXPECT_THROW(sum_of_distances(zero, equal), ArgumentError);
}

}  // namespace
}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <rapidcheck/gtest.h>
#include <set>
#include <string>
#include <tbb/task_arena.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/fusion.h"
#include "tests/retrieval/reranking_examples.h"

namespace shapegauge {
namespace {

DistanceMatrix line_distances(const std::vector<double>& coordinates) {
  const auto size = std::ssize(coordinates);
  DistanceMatrix matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) {
      matrix(i, j) = std::abs(coordinates[static_cast<std::size_t>(i)] - coordinates[static_cast<std::size_t>(j)]);
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

TEST(SumOfDistances, DividesEachMatrixByItsScaleAndMultipliesByItsWeight) {
  const DistanceMatrix a = line_distances({0, 1, 3});  // 1, 2, 3: median and mean 2
  const DistanceMatrix b = line_distances({0, 4, 6});  // 2, 4, 6: median and mean 4
  const std::vector both = {a, b};
  const std::vector<double> weights = {3, 2};
  EXPECT_EQ(sum_of_distances(both, weights, DistanceScale::none)(0, 1), 3 * 1 + 2 * 4);
  EXPECT_EQ(sum_of_distances(both, weights, DistanceScale::median)(0, 1), 3 * 0.5 + 2 * 1.0);
  EXPECT_EQ(sum_of_distances(both, weights, DistanceScale::mean)(0, 1), 3 * 0.5 + 2 * 1.0);
}

TEST(SumOfDistances, DividesDistancesByTheirMedianOrMeanAsChosen) {
  const std::vector one = {line_distances({0, 1, 11})};  // 1, 10, 11
  const std::vector<double> weight = {1};
  EXPECT_EQ(sum_of_distances(one, weight, DistanceScale::median)(0, 1), 0.1);
  EXPECT_NEAR(sum_of_distances(one, weight, DistanceScale::mean)(0, 1), 3.0 / 22, 1e-15);
}

TEST(SumOfDistances, DoesNotChangeIfAMatrixIsMultipliedByAConstant) {
  const DistanceMatrix a = random_distances(20, 1);
  const DistanceMatrix b = random_distances(20, 2);
  const std::vector plain = {a, b};
  const std::vector<DistanceMatrix> scaled = {a, 1024 * b};
  EXPECT_EQ(sum_of_distances(plain, equal), sum_of_distances(scaled, equal));
}

TEST(FusionOfRanks, ReciprocalRanksMatchAHandComputation) {
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

TEST(FusionOfRanks, BordaScoresMatchAHandComputation) {
  const DistanceMatrix a = line_distances({0, 1, 3});
  const DistanceMatrix b = line_distances({0, 3, 1});
  const std::vector both = {a, b};
  const DistanceMatrix fused = fusion_of_ranks(both, equal, RankScore::borda);
  // Ranks of (0, 1): 1 and 2; of (1, 0): 1 and 2. Scores 2 + 1 of 4 at most.
  EXPECT_NEAR(fused(0, 1), 1 - 3.0 / 4, 1e-15);
  // (1, 2): 2 and 1; (2, 1): 1 and 2.
  EXPECT_NEAR(fused(1, 2), 1 - 3.0 / 4, 1e-15);
}

TEST(FusionOfRanks, DependsOnlyOnTheOrderOfDistances) {
  const DistanceMatrix a = random_distances(30, 1);
  const DistanceMatrix b = random_distances(30, 2);
  const std::vector plain = {a, b};
  const std::vector<DistanceMatrix> bent = {a.cwiseAbs2(), b.cwiseSqrt()};
  for (const RankScore score : {RankScore::reciprocal, RankScore::borda}) {
    EXPECT_EQ(fusion_of_ranks(plain, equal, score), fusion_of_ranks(bent, equal, score));
  }
}

TEST(FusionOfRanks, AWeightOfZeroExcludesAMatrix) {
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

TEST(SumOfDistances, KeepsInfiniteDistancesAndExcludesThemFromScales) {
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

TEST(SumOfDistances, DoesNotOverflowForHugeDistances) {
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

/// Sum of locally scaled distances by direct evaluation of its definition.
DistanceMatrix local_reference(const std::vector<DistanceMatrix>& matrices, const std::vector<double>& weights) {
  const Eigen::Index n = matrices.front().rows();
  DistanceMatrix sum = DistanceMatrix::Zero(n, n);
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    const DistanceMatrix& d = matrices[k];
    std::vector<double> scales;
    for (Eigen::Index i = 0; i < n; ++i) {
      std::vector<double> others;
      for (Eigen::Index j = 0; j < n; ++j) {
        if (i != j && d(i, j) > 0 && std::isfinite(d(i, j))) others.push_back(d(i, j));
      }
      std::ranges::sort(others);
      others.resize(std::min<std::size_t>(others.size(), 10));
      const double total = std::accumulate(others.begin(), others.end(), 0.0);
      scales.push_back(others.empty() ? unreachable : total / static_cast<double>(others.size()));
    }
    std::vector<double> known;
    std::ranges::copy_if(scales, std::back_inserter(known), [](double scale) { return std::isfinite(scale); });
    std::ranges::sort(known);
    for (double& scale : scales) scale = std::isfinite(scale) ? std::max(scale, known[known.size() / 2] / 100) : 1;
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        const double scale = std::sqrt(scales[static_cast<std::size_t>(i)] * scales[static_cast<std::size_t>(j)]);
        if (weights[k] > 0) sum(i, j) += weights[k] * d(i, j) / scale;
      }
    }
  }
  return sum;
}

const std::vector<double> unequal = {1, 0.25};

TEST(LocalScale, MatchesADirectImplementation) {
  const std::vector plain = {random_distances(40, 1), test::distances_of(test::arcs(20, 2, 2))};
  std::vector gaps = plain;
  gaps[1] = test::with_gaps(gaps[1]);
  std::vector doubles = plain;  // eleven equal models and one that is almost equal
  for (const Eigen::Index i : {3, 5, 6, 9, 12, 20, 21, 25, 30, 31, 37}) {
    doubles[0].row(i) = doubles[0].row(3);
    doubles[0].col(i) = doubles[0].col(3);
  }
  doubles[0].row(7) = doubles[0].row(3).array() + 1e-9;
  doubles[0].col(7) = doubles[0].row(7).transpose();
  doubles[0].diagonal().setZero();
  for (const std::vector<DistanceMatrix>& matrices : {plain, gaps, doubles}) {
    const DistanceMatrix found = sum_of_distances(matrices, unequal, DistanceScale::local);
    test::expect_near(found, local_reference(matrices, unequal), 1e-10 * test::largest_finite(found));
    EXPECT_EQ(found, DistanceMatrix(found.transpose()));
  }
}

TEST(LocalScale, MakesDistancesWithinLooseAndTightGroupsEqual) {
  // The second group is the first, a hundred times as large.
  const DistanceMatrix group = random_distances(12, 4);
  DistanceMatrix both = DistanceMatrix::Constant(24, 24, 1000);
  both.topLeftCorner(12, 12) = group;
  both.bottomRightCorner(12, 12) = 100 * group;
  const DistanceMatrix scaled = sum_of_distances({&both, 1}, std::vector<double>{1}, DistanceScale::local);
  EXPECT_LT((scaled.topLeftCorner(12, 12) - scaled.bottomRightCorner(12, 12)).cwiseAbs().maxCoeff(), 1e-12);
}

RC_GTEST_PROP(LocalScale, DoesNotDependOnTheUnitsOfAMatrix, ()) {
  const auto size = *rc::gen::inRange<Eigen::Index>(1, 30);
  const std::vector<DistanceMatrix> plain = {random_distances(size, *rc::gen::arbitrary<std::uint64_t>()),
                                             random_distances(size, *rc::gen::arbitrary<std::uint64_t>())};
  const std::vector<DistanceMatrix> scaled = {plain[0], std::ldexp(1, *rc::gen::inRange(-900, 900)) * plain[1]};
  const DistanceMatrix expected = sum_of_distances(plain, unequal, DistanceScale::local);
  const DistanceMatrix found = sum_of_distances(scaled, unequal, DistanceScale::local);
  RC_ASSERT((found - expected).cwiseAbs().maxCoeff() <= 1e-12 * expected.maxCoeff());
}

TEST(LocalScale, GivesNoNanForSingleEqualOrInfinitelyDistantModels) {
  const auto alone = [](const DistanceMatrix& matrix) {
    return sum_of_distances({&matrix, 1}, std::vector<double>{1}, DistanceScale::local);
  };
  EXPECT_EQ(alone(DistanceMatrix::Zero(1, 1)), DistanceMatrix::Zero(1, 1));
  EXPECT_EQ(alone(DistanceMatrix::Zero(5, 5)), DistanceMatrix::Zero(5, 5));
  EXPECT_NEAR(alone(line_distances({0, 3}))(0, 1), 1, 1e-15);
  EXPECT_EQ(alone(DistanceMatrix{{0, unreachable}, {unreachable, 0}})(0, 1), unreachable);
  for (const double far : {1e200, std::numeric_limits<double>::max()}) {
    DistanceMatrix matrix = random_distances(20, 3);
    matrix.row(4).setConstant(far);
    matrix.col(4).setConstant(far);
    matrix(4, 4) = 0;
    EXPECT_TRUE(alone(matrix).allFinite());
  }
}

/// Distances of three classes of ten models, with noise.
DistanceMatrix noisy_classes(double noise, std::uint64_t seed) {
  RandomNumbers random(seed);
  Eigen::MatrixXd points(30, 6);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index k = 0; k < points.cols(); ++k) {
      points(i, k) = (i / 10 == k % 3 ? 1 : 0) + random.uniform(-noise, noise);
    }
  }
  return test::distances_of(points);
}

/// A model and its k nearest neighbours.
std::set<Eigen::Index> nearest_set(const DistanceMatrix& distances, Eigen::Index model, int k) {
  std::vector<Eigen::Index> order = test::random_order(distances.rows(), 1);
  std::ranges::sort(order, {}, [&](Eigen::Index other) { return other == model ? -1 : distances(model, other); });
  return {order.begin(), order.begin() + k + 1};
}

double common(const std::set<Eigen::Index>& a, const std::set<Eigen::Index>& b) {
  return static_cast<double>(std::ranges::count_if(a, [&](Eigen::Index model) { return b.contains(model); }));
}

TEST(SumWeights, ByAgreementMatchADirectImplementation) {
  const std::vector<DistanceMatrix> matrices = {noisy_classes(0.3, 1), noisy_classes(1, 2), random_distances(30, 3)};
  const std::vector<double> weights = {1, 0.5, 2};
  const std::vector<double> found = sum_weights(matrices, weights, SumWeights::agreement);
  for (std::size_t m = 0; m < 3; ++m) {
    double agreement = 0;
    double cohesion = 0;
    for (const int k : {4, 5, 7, 10, 14, 20}) {
      for (Eigen::Index i = 0; i < 30; ++i) {
        const std::set<Eigen::Index> neighbours = nearest_set(matrices[m], i, k);
        for (std::size_t other = 0; other < 3; ++other) {
          if (other == m) continue;
          const double share = (common(neighbours, nearest_set(matrices[other], i, k)) - 1) / k;
          agreement += weights[other] / (3.5 - weights[m]) * share / 30 / 6;
        }
        for (const Eigen::Index j : neighbours) {
          const std::set<Eigen::Index> theirs = nearest_set(matrices[m], j, k);
          const double both = common(neighbours, theirs);
          if (j != i) cohesion += both / (static_cast<double>(neighbours.size() + theirs.size()) - both) / k / 30 / 6;
        }
      }
    }
    // Compared before the power, after which most of the factors are below any absolute tolerance.
    EXPECT_NEAR(std::pow(found[m] / weights[m], 1.0 / 4), agreement * cohesion, 1e-12);
  }
  EXPECT_EQ(sum_weights(matrices, weights, SumWeights::given), weights);
}

TEST(SumWeights, ByAgreementOfNeighboursAreSmallForRandomDistances) {
  const std::vector<DistanceMatrix> matrices = {noisy_classes(0.3, 1), noisy_classes(0.3, 2), random_distances(30, 3)};
  const std::vector<double> weights = sum_weights(matrices, std::vector<double>(3, 1), SumWeights::agreement);
  EXPECT_LT(2 * weights[2], std::min(weights[0], weights[1]));
}

TEST(SumWeights, DoNotDependOnTheOrderOfModels) {
  DistanceMatrix whole_numbers = (10 * noisy_classes(0.5, 5)).array().round();
  const std::vector<DistanceMatrix> matrices = {noisy_classes(0.3, 1), whole_numbers};
  const std::vector<Eigen::Index> order = test::random_order(30, 8);
  const std::vector<DistanceMatrix> permuted = {matrices[0](order, order), matrices[1](order, order)};
  const std::vector<double> weights = sum_weights(matrices, equal, SumWeights::agreement);
  const std::vector<double> of_permuted = sum_weights(permuted, equal, SumWeights::agreement);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(of_permuted[k], weights[k], 1e-13);
  const DistanceMatrix sum = sum_of_distances(matrices, weights, DistanceScale::local);
  const DistanceMatrix found = sum_of_distances(permuted, weights, DistanceScale::local);
  EXPECT_LT(test::largest_difference(found, sum(order, order)), 1e-12);
}

TEST(SumWeights, AreUnchangedIfAgreementCannotBeMeasured) {
  const std::vector<DistanceMatrix> constant = {DistanceMatrix::Constant(20, 20, 1),
                                                DistanceMatrix::Constant(20, 20, 2)};
  const std::vector<DistanceMatrix> one = {DistanceMatrix::Zero(1, 1), DistanceMatrix::Zero(1, 1)};
  const std::vector<DistanceMatrix> infinite(2, DistanceMatrix::Constant(9, 9, unreachable));
  for (const auto& matrices : {constant, one, infinite})
    EXPECT_EQ(sum_weights(matrices, unequal, SumWeights::agreement), unequal);
  const std::vector<DistanceMatrix> both = {noisy_classes(0.3, 1), noisy_classes(0.3, 2)};
  EXPECT_EQ(sum_weights(both, std::vector<double>{3, 0}, SumWeights::agreement), (std::vector<double>{3, 0}));
  const std::vector<DistanceMatrix> few = {line_distances({0, 1, 3}), line_distances({0, 5, 1})};
  EXPECT_EQ(sum_weights(few, unequal, SumWeights::agreement), unequal);  // all models are near each other
}

TEST(LocalSpreadScale, GivesTheSameSumsAsTheScaleByRanks) {
  const std::vector<DistanceMatrix> matrices = {noisy_classes(0.3, 1), random_distances(30, 3)};
  EXPECT_EQ(sum_of_distances(matrices, unequal, DistanceScale::local_spread),
            sum_of_distances(matrices, unequal, DistanceScale::ranks));
}

TEST(DisagreementWarning, NamesTheMatrixWhoseNeighboursDifferFromTheOthers) {
  const DistanceMatrix groups = test::distances_of(test::clusters(20, 6, 1));
  const std::vector<Eigen::Index> order = test::random_order(120, 5);
  const std::vector<DistanceMatrix> others = {groups, groups.cwiseAbs2(), groups(order, order)};
  const auto found = find_disagreement(others, std::vector<double>(3, 1));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->second, 2U);
  EXPECT_LT(found->agreement, 0.5 * found->cohesion);
  EXPECT_FALSE(find_disagreement(others, std::vector<double>{1, 1, 0}));
  EXPECT_FALSE(find_disagreement({others.data(), 2}, equal));
}

TEST(DistanceFusion, IsTheSameOnAnyNumberOfThreads) {
  const std::vector<DistanceMatrix> matrices = {noisy_classes(0.3, 1), test::with_gaps(noisy_classes(1, 2))};
  const auto on = [&](int threads) {
    tbb::task_arena arena(threads);
    return arena.execute([&] {
      return sum_of_distances(matrices, sum_weights(matrices, equal, SumWeights::agreement), DistanceScale::local);
    });
  };
  const DistanceMatrix one = on(1);
  EXPECT_EQ(std::memcmp(one.data(), on(4).data(), sizeof(double) * static_cast<std::size_t>(one.size())), 0);
}

TEST(FusionOfRanks, KeepsInfiniteDistancesOfUnrankedModels) {
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
    // Ranked by one of two methods: half of the score of both.
    const double with_both = 1 - fusion_of_ranks(both, equal, score)(2, 3);
    EXPECT_NEAR(2 * with_both, 1 - fusion_of_ranks(std::vector{b}, std::vector<double>{1}, score)(2, 3), 1e-12);
  }
}

TEST(DistanceFusion, RejectsMatricesOfDifferentSizesAndInvalidDistances) {
  const DistanceMatrix a = random_distances(5, 1);
  DistanceMatrix broken = a;
  broken(1, 2) = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::vector<DistanceMatrix>> unusable = {
      {}, {a}, {a, random_distances(6, 1)}, {a, DistanceMatrix::Zero(5, 4)}, {a, broken}, {a, -a}};
  for (const auto& matrices : unusable) {
    EXPECT_THROW(sum_of_distances(matrices, equal), ArgumentError);
    EXPECT_THROW(fusion_of_ranks(matrices, equal), ArgumentError);
    EXPECT_THROW(sum_weights(matrices, equal, SumWeights::agreement), ArgumentError);
  }
  try {
    sum_of_distances(std::vector{a, broken}, equal);
  } catch (const ArgumentError& error) {
    EXPECT_NE(std::string(error.what()).find("row 1, column 2 of fused matrix 1 "), std::string::npos) << error.what();
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

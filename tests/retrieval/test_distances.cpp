// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/distances.h"

namespace shapegauge {

namespace {

using Vector = std::vector<float>;

double distance(const std::string& name, const Vector& a, const Vector& b) {
  return distances().at(name).function(a, b);
}

TEST(Chi2Distance, DividesSquaredDifferencesByTheSumsOfBins) {
  // (0.25^2 / 0.75 + 0.25^2 / 0.75) / 2, and 0 for the bin that is empty in both.
  EXPECT_NEAR(distance("chi2", Vector{0.5F, 0.25F, 0, 0.25F}, Vector{0.25F, 0.5F, 0, 0.25F}), 1.0 / 12, 1e-15);
  EXPECT_EQ(distance("chi2", Vector{1, 0}, Vector{0, 1}), 1);
}

TEST(CosineDistance, DependsOnlyOnTheAngleBetweenVectors) {
  EXPECT_NEAR(distance("cosine", Vector{1, 0}, Vector{5, 5}), 1 - std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(distance("cosine", Vector{1, 0}, Vector{0, 3}), 1, 1e-15);
  EXPECT_NEAR(distance("cosine", Vector{1, 0}, Vector{-2, 0}), 2, 1e-15);
  EXPECT_EQ(distance("cosine", Vector{1, 2, 3}, Vector{2, 4, 6}), 0);
}

TEST(EarthMoversDistance, IsTheMovedMassTimesTheDistanceInBins) {
  EXPECT_EQ(distance("emd", Vector{1, 0, 0, 0}, Vector{0, 0, 0, 1}), 3);
  EXPECT_EQ(distance("emd", Vector{1, 0, 0, 0}, Vector{0, 2, 0, 0}), 1);
  EXPECT_EQ(distance("emd", Vector{0.5F, 0, 0.5F}, Vector{0, 1, 0}), 1);
  EXPECT_EQ(distance("emd", Vector{2}, Vector{5}), 0);
}

TEST(HellingerDistance, MatchesItsFormulaForNormalisedHistograms) {
  // The square root of 1 - sum of sqrt(p q), with p = (1/2, 1/2) and q = (1/8, 7/8).
  EXPECT_NEAR(distance("hellinger", Vector{0.5F, 0.5F}, Vector{0.125F, 0.875F}),
              std::sqrt(1 - std::sqrt(0.5 * 0.125) - std::sqrt(0.5 * 0.875)), 1e-15);
  EXPECT_EQ(distance("hellinger", Vector{3, 0}, Vector{0, 2}), 1);
  EXPECT_EQ(distance("hellinger", Vector{1, 2, 1}, Vector{2, 4, 2}), 0);
}

TEST(JensenShannonDistance, IsTheSquareRootOfTheMeanDivergenceFromTheAverage) {
  // p = (1, 0), q = (1/2, 1/2), mean (3/4, 1/4): 1 log2(4/3) and 1/2 log2(2/3) + 1/2 log2(2).
  const double divergence = (std::log2(4.0 / 3) + 0.5 * std::log2(2.0 / 3) + 0.5) / 2;
  EXPECT_NEAR(distance("jensen-shannon", Vector{1, 0}, Vector{2, 2}), std::sqrt(divergence), 1e-15);
  EXPECT_EQ(distance("jensen-shannon", Vector{3, 0}, Vector{0, 2}), 1);
  EXPECT_EQ(distance("jensen-shannon", Vector{0.1F, 0.7F}, Vector{0.1F, 0.7F}), 0);
}

TEST(L2Distance, IsEuclidean) {
  EXPECT_EQ(distance("l2", Vector{1, 2, 5}, Vector{4, 6, 5}), 5);
  EXPECT_EQ(distance("l2", {}, {}), 0);
}

std::vector<float> random_histogram(std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<float> histogram(12);
  for (float& bin : histogram) bin = std::max(0.0F, uniform(random) - 0.3F);
  histogram[0] += 0.01F;
  return histogram;
}

// Assumptions of distance matrices.
TEST(DistanceRegistry, DistancesAreSymmetricNonNegativeAndZeroForEqualSignatures) {
  std::mt19937 random(4);
  for (int i = 0; i < 50; ++i) {
    const std::vector<float> a = random_histogram(random);
    const std::vector<float> b = random_histogram(random);
    for (const NamedDistance& distance : distances().entries()) {
      EXPECT_EQ(distance.function(a, a), 0) << distance.name;
      EXPECT_GT(distance.function(a, b), 0) << distance.name;
      EXPECT_NEAR(distance.function(a, b), distance.function(b, a), 1e-15) << distance.name;
    }
  }
}

// Registers a distance as a user of the library would.
TEST(DistanceRegistry, AcceptsAUserDefinedDistance) {
  distances().add({.name = "chebyshev", .function = [](std::span<const float> a, std::span<const float> b) {
                     double largest = 0;
                     for (std::size_t i = 0; i < a.size(); ++i) {
                       largest = std::max(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
                     }
                     return largest;
                   }});
  EXPECT_EQ(distances().names().back(), "chebyshev");
  const Signatures signatures{{0, 0}, {1, 3}, {2, -1}};
  EXPECT_EQ(distance_matrix(signatures, "chebyshev"), (DistanceMatrix{{0, 3, 2}, {3, 0, 4}, {2, 4, 0}}));
}

TEST(DistanceRegistry, RejectsMissingFunctionsAndEmptyOrDuplicateNames) {
  const auto zero = [](std::span<const float>, std::span<const float>) { return 0.0; };
  EXPECT_THROW(distances().add({.name = "", .function = zero}), ArgumentError);
  EXPECT_THROW(distances().add({.name = "l1", .function = zero}), ArgumentError);
  EXPECT_THROW(distances().add({.name = "nothing"}), ArgumentError);
}

}  // namespace

}  // namespace shapegauge

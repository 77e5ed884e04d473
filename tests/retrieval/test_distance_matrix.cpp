// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <rapidcheck/gtest.h>
#include <span>
#include <tbb/global_control.h>

#include "shapegauge/core/base/cancellation.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "shapegauge/retrieval/distances.h"

namespace shapegauge {

namespace {

Signatures random_signatures(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  return Signatures::NullaryExpr(rows, columns, [&] { return uniform(generator); });
}

DistanceMatrix with_threads(const Signatures& signatures, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  return distance_matrix(signatures);
}

TEST(DistanceMatrix, ListsTheNamesOfAllDistanceMeasures) {
  EXPECT_THAT(distances().names(),
              testing::ElementsAre("l1", "l2", "cosine", "chi2", "hellinger", "jensen-shannon", "emd"));
}

TEST(DistanceMatrix, MatchesAHandComputedExample) {
  const Signatures signatures{{0, 0}, {1, 2}, {-1, 0.5F}};
  const DistanceMatrix expected{{0, 3, 1.5}, {3, 0, 3.5}, {1.5, 3.5, 0}};
  EXPECT_EQ(distance_matrix(signatures), expected);
}

TEST(DistanceMatrix, IsEmptyWithoutSignatures) { EXPECT_EQ(distance_matrix(Signatures(0, 5)).size(), 0); }

TEST(DistanceMatrix, IsTheSameOnAnyNumberOfThreads) {
  const Signatures signatures = random_signatures(151, 80, 7);
  const DistanceMatrix one = with_threads(signatures, 1);
  EXPECT_EQ(with_threads(signatures, 2), one);
  EXPECT_EQ(with_threads(signatures, 5), one);
}

TEST(DistanceMatrix, RowsComputedSeparatelyEqualRowsOfTheWholeMatrix) {
  const Signatures signatures = random_signatures(101, 43, 11);
  for (const std::string& distance : distances().names()) {
    const DistanceMatrix whole = distance_matrix(signatures, distance);
    const NamedDistance named = distances().at(distance);
    EXPECT_EQ(distance_rows(signatures, 0, 101, named), whole) << distance;
    EXPECT_EQ(distance_rows(signatures, 37, 40, named), whole.middleRows(37, 40)) << distance;
  }
  EXPECT_EQ(distance_rows(signatures, 101, 0, distances().at("l1")).size(), 0);
  EXPECT_THROW(distance_rows(signatures, 100, 2, distances().at("l1")), ArgumentError);
}

TEST(DistanceMatrix, BlocksComputedSeparatelyEqualBlocksOfTheWholeMatrix) {
  const Signatures signatures = random_signatures(7, 5, 4);
  const DistanceMatrix whole = distance_matrix(signatures, "l2");
  for (const Eigen::Index first : {0, 2, 4}) {
    const DistanceMatrix block = distances_between(distances().at("l2"), {signatures.middleRows(1, 4), 1},
                                                   {signatures.middleRows(first, 3), first});
    EXPECT_EQ(block, whole.block(1, first, 4, 3)) << first;
  }
}

std::string error_of(const Signatures& signatures, const std::string& distance) {
  try {
    distance_matrix(signatures, distance);
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "no error";
}

TEST(DistanceMatrix, ErrorsNameTheUnknownDistanceOrTheNonFiniteEntry) {
  Signatures signatures = Signatures::Ones(4, 3);
  EXPECT_THAT(error_of(signatures, "manhatten"), testing::HasSubstr("\"manhatten\""));
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    signatures(2, 1) = bad;
    EXPECT_THAT(error_of(signatures, "l1"), testing::HasSubstr("entry 1 of signature 2"));
  }
}

TEST(DistanceMatrix, RejectsSignaturesOutsideTheDomainOfADistance) {
  Signatures signatures = Signatures::Ones(3, 2);
  signatures.row(1).setZero();
  for (const char* name : {"cosine", "hellinger", "jensen-shannon", "emd"}) {
    EXPECT_THAT(error_of(signatures, name), testing::HasSubstr("signature 1")) << name;
  }
  for (const char* name : {"l1", "l2", "chi2"}) EXPECT_EQ(error_of(signatures, name), "no error");
  signatures.row(1) << 2, -1;
  for (const char* name : {"chi2", "hellinger", "jensen-shannon", "emd"}) {
    EXPECT_THAT(error_of(signatures, name), testing::HasSubstr("signature 1")) << name;
  }
  for (const char* name : {"l1", "l2", "cosine"}) EXPECT_EQ(error_of(signatures, name), "no error");
}

Cancellation* cancelled_by_distance = nullptr;
std::atomic<int> calls_of_distance = 0;

double cancelling_distance(std::span<const float>, std::span<const float>) {
  ++calls_of_distance;
  cancelled_by_distance->cancel();
  return 0;
}

TEST(DistanceMatrix, CancellationStopsTheComputationAfterFewDistances) {
  const Signatures signatures = random_signatures(500, 4, 1);
  const SignatureBlock block{signatures, 0};
  Cancellation cancellation;
  cancelled_by_distance = &cancellation;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_THROW(
      cancellation.run([&] { distances_between({.name = "slow", .function = cancelling_distance}, block, block); }),
      Interrupted);
  EXPECT_LE(calls_of_distance, 32) << "the rest of a row of a tile";
}

RC_GTEST_PROP(DistanceMatrix, EveryEntryMatchesTheL1NormOfTheDifference, ()) {
  const auto rows = *rc::gen::inRange<Eigen::Index>(0, 80);
  const auto columns = *rc::gen::inRange<Eigen::Index>(0, 40);
  const Signatures signatures = random_signatures(rows, columns, *rc::gen::arbitrary<unsigned>());
  const DistanceMatrix matrix = distance_matrix(signatures);
  RC_ASSERT(matrix.rows() == rows);
  RC_ASSERT(matrix.cols() == rows);
  const auto precise = signatures.cast<double>().eval();
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < rows; ++j) {
      // Another order of summation may round each addition differently.
      RC_ASSERT(std::abs(matrix(i, j) - (precise.row(i) - precise.row(j)).lpNorm<1>()) <= 1e-14 * (1 + matrix(i, j)));
    }
  }
}

}  // namespace

}  // namespace shapegauge

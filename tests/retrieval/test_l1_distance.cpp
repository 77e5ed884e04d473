// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <span>
#include <utility>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/l1_distance.h"

namespace shapegauge {

namespace {

TEST(L1Distance, SumsAbsoluteDifferences) {
  const std::vector<float> a = {1, 0.5F, -2};
  const std::vector<float> b = {0, 0.75F, 1};
  EXPECT_EQ(l1_distance(a, b), 4.25);
  EXPECT_EQ(l1_distance(b, a), 4.25);
  EXPECT_EQ(l1_distance(a, a), 0);
}

TEST(L1Distance, IsTwoForDisjointHistograms) {
  const std::vector<float> a = {0.5F, 0.5F, 0, 0};
  const std::vector<float> b = {0, 0, 0.25F, 0.75F};
  EXPECT_EQ(l1_distance(a, b), 2);
}

TEST(L1Distance, SumsInDoublePrecision) {
  // 2^24 + 1 is not a float; a single-precision sum would lose the last entry.
  const std::vector<float> a = {16777216.0F, 1};
  const std::vector<float> b = {0, 0};
  EXPECT_EQ(l1_distance(a, b), 16777217.0);
}

TEST(L1Distance, OfEmptySignaturesIsZero) { EXPECT_EQ(l1_distance({}, {}), 0); }

// Definition in the header, entry by entry.
double eight_sums(std::span<const float> a, std::span<const float> b) {
  std::array<double, 8> sums{};
  for (std::size_t i = 0; i < a.size(); ++i) {
    sums[i % 8] += std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
  }
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

TEST(L1Distance, OfBlocksOfSignaturesEqualsTheDistanceOfEachPair) {
  RandomNumbers random(1);
  const auto entries = [&](std::size_t count) {
    std::vector<float> result(count);
    for (float& entry : result) entry = static_cast<float>(random.uniform(-1, 1));
    return result;
  };
  for (const std::size_t size : {1U, 7U, 8U, 80U, 240U, 243U}) {
    for (const auto& [rows, columns] : {std::pair<std::size_t, std::size_t>{1, 1}, {2, 4}, {3, 11}, {5, 6}}) {
      const std::vector<float> some = entries(rows * size);
      const std::vector<float> others = entries(columns * size);
      std::vector<double> distances(rows * columns);
      l1_distances(some, others, size, distances);
      for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
          const auto a = std::span(some).subspan(i * size, size);
          const auto b = std::span(others).subspan(j * size, size);
          EXPECT_EQ(distances[i * columns + j], eight_sums(a, b)) << size;
          EXPECT_EQ(distances[i * columns + j], l1_distance(b, a)) << size;
        }
      }
    }
  }
}

TEST(L1Distance, IsIdenticalOnEveryInstructionSet) {
  RandomNumbers random(2);
  std::vector<float> signatures(9 * 243);
  for (float& entry : signatures) entry = static_cast<float>(random.uniform(0, 1));
  std::vector<double> expected(81);
  l1_distances(signatures, signatures, 243, expected);
  for (const auto target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    std::vector<double> distances(81);
    l1_distances(signatures, signatures, 243, distances);
    EXPECT_EQ(distances, expected) << hwy::TargetName(target);
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(L1Distance, OfBlocksOfEmptySignaturesIsZero) {
  std::vector<double> distances(6, 1);
  l1_distances({}, {}, 0, distances);
  EXPECT_THAT(distances, testing::Each(0));
}

RC_GTEST_PROP(L1Distance, IsWithinItsErrorBoundOfTheExactSum, ()) {
  const auto size = *rc::gen::inRange<std::size_t>(1, 300);
  RandomNumbers random(*rc::gen::arbitrary<unsigned>(), 0);
  const double differences = std::pow(10, random.uniform(-12, 0));  // of entries, relative to themselves
  std::vector<float> a(size);
  std::vector<float> b(size);
  long double precise = 0;
  for (std::size_t i = 0; i < size; ++i) {
    a[i] = static_cast<float>(std::pow(10, random.uniform(-20, 20)));
    b[i] = static_cast<float>(a[i] * (1 + differences * random.uniform(-1, 1)));
    precise += std::abs(static_cast<long double>(a[i]) - static_cast<long double>(b[i]));
  }
  const double bound = (static_cast<double>(size) / 8 + 5) * std::numeric_limits<double>::epsilon() / 2;
  RC_ASSERT(std::abs(l1_distance(a, b) - precise) <= bound * precise);
}

}  // namespace

}  // namespace shapegauge

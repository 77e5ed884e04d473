// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <gtest/gtest.h>
#include <set>

#include "shapegauge/core/base/random_numbers.h"

namespace shapegauge {

namespace {

TEST(RandomNumbers, StreamsAreReproducibleAndDifferFromEachOther) {
  RandomNumbers a(5, 1);
  RandomNumbers b(5, 1);
  RandomNumbers other_stream(5, 2);
  RandomNumbers other_seed(6, 1);
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t number = a.next();
    EXPECT_EQ(number, b.next());
    EXPECT_NE(number, other_stream.next());
    EXPECT_NE(number, other_seed.next());
  }
}

TEST(RandomNumbers, StreamsOfOneSeedBeginDifferently) {
  std::set<std::uint64_t> first;
  for (std::uint64_t stream = 0; stream < 1000; ++stream) first.insert(RandomNumbers(5, stream).next());
  EXPECT_EQ(first.size(), 1000U);
}

TEST(RandomNumbers, UniformNumbersStayInRangeWithTheExpectedMeanAndVariance) {
  RandomNumbers random(1);
  constexpr int n = 100000;
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < n; ++i) {
    const double x = random.uniform(-2, 4);
    ASSERT_GE(x, -2);
    ASSERT_LT(x, 4);
    sum += x;
    squares += x * x;
  }
  const double mean = sum / n;
  // Standard deviation sqrt(3) over sqrt(n) = 0.0055; five of them.
  EXPECT_NEAR(mean, 1, 0.028);
  EXPECT_NEAR(squares / n - mean * mean, 3, 0.05);
}

TEST(RandomNumbers, IntegersBelowALimitAreUniformlyDistributed) {
  RandomNumbers random(1);
  constexpr int n = 70000;
  std::array<int, 7> drawn{};
  for (int i = 0; i < n; ++i) ++drawn.at(random.below(drawn.size()));
  // Standard deviation sqrt(n 6 / 49) = 93; five of them.
  for (const int count : drawn) EXPECT_NEAR(count, n / 7, 463);
  EXPECT_EQ(random.below(1), 0U);
}

TEST(RandomSubset, HasTheRequestedSizeAndContainsEachElementEquallyOften) {
  RandomNumbers random(2);
  std::array<int, 8> times{};
  for (int i = 0; i < 40000; ++i) {
    const std::vector<bool> chosen = random_subset(times.size(), 3, random);
    ASSERT_EQ(std::ranges::count(chosen, true), 3);
    for (std::size_t k = 0; k < times.size(); ++k) times[k] += chosen[k] ? 1 : 0;
  }
  // 40000 times 3/8, standard deviation 97; five of them.
  for (const int t : times) EXPECT_NEAR(t, 15000, 485);
  EXPECT_EQ(random_subset(3, 3, random), std::vector<bool>(3, true));
  EXPECT_EQ(random_subset(3, 0, random), std::vector<bool>(3, false));
  EXPECT_TRUE(random_subset(0, 0, random).empty());
}

}  // namespace

}  // namespace shapegauge

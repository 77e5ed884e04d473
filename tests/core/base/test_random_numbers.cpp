#include <array>
#include <gtest/gtest.h>

#include "shapegauge/core/base/random_numbers.h"

namespace shapegauge {

namespace {

TEST(RandomNumbers, AStreamRepeatsAndStreamsDiffer) {
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

TEST(RandomNumbers, UniformStaysInRangeAndHasItsMeanAndVariance) {
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

TEST(RandomNumbers, BelowDrawsEveryNumberAboutAsOften) {
  RandomNumbers random(1);
  constexpr int n = 70000;
  std::array<int, 7> drawn{};
  for (int i = 0; i < n; ++i) ++drawn.at(random.below(drawn.size()));
  // Standard deviation sqrt(n 6 / 49) = 93; five of them.
  for (const int count : drawn) EXPECT_NEAR(count, n / 7, 463);
  EXPECT_EQ(random.below(1), 0U);
}

}  // namespace

}  // namespace shapegauge

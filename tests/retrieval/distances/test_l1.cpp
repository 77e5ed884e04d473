#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <span>
#include <vector>

#include "shapegauge/random/random_numbers.h"
#include "shapegauge/retrieval/distances/l1.h"

namespace shapegauge {
namespace {

TEST(L1, SumsAbsoluteDifferences) {
  const std::vector<float> a = {1, 0.5F, -2};
  const std::vector<float> b = {0, 0.75F, 1};
  EXPECT_EQ(l1_distance(a, b), 4.25);
  EXPECT_EQ(l1_distance(b, a), 4.25);
  EXPECT_EQ(l1_distance(a, a), 0);
}

TEST(L1, IsTwoForDisjointHistograms) {
  const std::vector<float> a = {0.5F, 0.5F, 0, 0};
  const std::vector<float> b = {0, 0, 0.25F, 0.75F};
  EXPECT_EQ(l1_distance(a, b), 2);
}

TEST(L1, SumsInDoublePrecision) {
  // 2^24 + 1 is no float; a sum in single precision would lose the last entry.
  const std::vector<float> a = {16777216.0F, 1};
  const std::vector<float> b = {0, 0};
  EXPECT_EQ(l1_distance(a, b), 16777217.0);
}

TEST(L1, OfNothingIsZero) { EXPECT_EQ(l1_distance({}, {}), 0); }

TEST(L1, ToSeveralIsTheSameBitByBit) {
  RandomNumbers random(1);
  for (const std::size_t size : {1U, 7U, 8U, 80U, 240U, 243U}) {
    const std::size_t count = 11;
    std::vector<float> signatures(size * (count + 1));
    for (float& entry : signatures) entry = static_cast<float>(random.uniform(-1, 1));
    const std::span<const float> first = std::span(signatures).first(size);
    const std::span<const float> others = std::span(signatures).subspan(size);
    std::vector<double> distances(count);
    l1_distances(first, others, distances);
    for (std::size_t k = 0; k < count; ++k) {
      EXPECT_EQ(distances[k], l1_distance(first, others.subspan(k * size, size))) << size;
      double plain = 0;
      for (std::size_t i = 0; i < size; ++i) {
        plain += std::abs(static_cast<double>(first[i]) - static_cast<double>(others[k * size + i]));
      }
      EXPECT_NEAR(distances[k], plain, 1e-12 * plain) << size;
    }
  }
}

}  // namespace
}  // namespace shapegauge

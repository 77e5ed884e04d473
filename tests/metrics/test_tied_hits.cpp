#include <gtest/gtest.h>
#include <numeric>

#include "shapegauge/metrics/tied_hits.h"

namespace shapegauge {
namespace {

TEST(TiedHits, OneHitIsAtAnyRankAlike) {
  std::vector<double> precisions;
  append_precisions(precisions, 4, 1, 2);
  ASSERT_EQ(precisions.size(), 1U);
  EXPECT_DOUBLE_EQ(precisions[0], (1.0 / 3 + 1.0 / 4 + 1.0 / 5 + 1.0 / 6) / 4);
}

TEST(TiedHits, HitsCountOnFromThoseBefore) {
  // Orders of {hit, miss, hit} behind a hit at rank 1 and a miss: second hit at 3, 3, 4; third at 4, 5, 5.
  std::vector<double> precisions = {1};
  append_precisions(precisions, 3, 2, 2);
  EXPECT_DOUBLE_EQ(precisions[1], 2 * (1.0 / 3 + 1.0 / 3 + 1.0 / 4) / 3);
  EXPECT_DOUBLE_EQ(precisions[2], 3 * (1.0 / 4 + 1.0 / 5 + 1.0 / 5) / 3);
}

// The mean of the sum of the precisions at all hits also has a closed form: in n ranks with m hits, rank i is a hit
// with the probability m/n, and then 1 + (i - 1)(m - 1)/(n - 1) hits are among the first i.
TEST(TiedHits, AgreeWithTheClosedFormOfAveragePrecisionForLargeTies) {
  for (const auto& [size, hits] : {std::pair{20000, 19}, {20000, 10000}, {3001, 3000}, {1000, 2}}) {
    std::vector<double> precisions;
    append_precisions(precisions, static_cast<std::size_t>(size), static_cast<std::size_t>(hits), 0);
    double expected = 0;
    for (int i = 1; i <= size; ++i) {
      expected += (1 + (i - 1.0) * (hits - 1.0) / (size - 1.0)) / i * hits / size;
    }
    const double sum = std::accumulate(precisions.begin(), precisions.end(), 0.0);
    EXPECT_NEAR(sum, expected, 1e-11 * expected) << size << " " << hits;
  }
}

}  // namespace
}  // namespace shapegauge

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/retrieval/distances/hellinger.h"

namespace shapegauge {
namespace {

using Vector = std::vector<float>;

TEST(Hellinger, ComparesSquareRoots) {
  // The square root of 1 - sum of sqrt(p q), with p = (1/2, 1/2) and q = (1/8, 7/8).
  EXPECT_NEAR(hellinger_distance(Vector{0.5F, 0.5F}, Vector{0.125F, 0.875F}),
              std::sqrt(1 - std::sqrt(0.5 * 0.125) - std::sqrt(0.5 * 0.875)), 1e-15);
  EXPECT_EQ(hellinger_distance(Vector{3, 0}, Vector{0, 2}), 1);
  EXPECT_EQ(hellinger_distance(Vector{1, 2, 1}, Vector{2, 4, 2}), 0);
}

}  // namespace
}  // namespace shapegauge

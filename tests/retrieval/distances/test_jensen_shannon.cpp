#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/retrieval/distances/jensen_shannon.h"

namespace shapegauge {
namespace {

using Vector = std::vector<float>;

TEST(JensenShannon, IsTheRootOfTheMeanDivergence) {
  // p = (1, 0), q = (1/2, 1/2), mean (3/4, 1/4): 1 log2(4/3) and 1/2 log2(2/3) + 1/2 log2(2).
  const double divergence = (std::log2(4.0 / 3) + 0.5 * std::log2(2.0 / 3) + 0.5) / 2;
  EXPECT_NEAR(jensen_shannon_distance(Vector{1, 0}, Vector{2, 2}), std::sqrt(divergence), 1e-15);
  EXPECT_EQ(jensen_shannon_distance(Vector{3, 0}, Vector{0, 2}), 1);
  EXPECT_EQ(jensen_shannon_distance(Vector{0.1F, 0.7F}, Vector{0.1F, 0.7F}), 0);
}

}  // namespace
}  // namespace shapegauge

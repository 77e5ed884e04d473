#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/retrieval/distances/l2.h"

namespace shapegauge {
namespace {

using Vector = std::vector<float>;

TEST(L2, IsEuclidean) {
  EXPECT_EQ(l2_distance(Vector{1, 2, 5}, Vector{4, 6, 5}), 5);
  EXPECT_EQ(l2_distance({}, {}), 0);
}

}  // namespace
}  // namespace shapegauge

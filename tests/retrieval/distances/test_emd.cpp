#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/retrieval/distances/emd.h"

namespace shapegauge {
namespace {

using Vector = std::vector<float>;

TEST(Emd, IsTheWorkInBins) {
  EXPECT_EQ(earth_movers_distance(Vector{1, 0, 0, 0}, Vector{0, 0, 0, 1}), 3);
  EXPECT_EQ(earth_movers_distance(Vector{1, 0, 0, 0}, Vector{0, 2, 0, 0}), 1);
  EXPECT_EQ(earth_movers_distance(Vector{0.5F, 0, 0.5F}, Vector{0, 1, 0}), 1);
  EXPECT_EQ(earth_movers_distance(Vector{2}, Vector{5}), 0);
}

}  // namespace
}  // namespace shapegauge

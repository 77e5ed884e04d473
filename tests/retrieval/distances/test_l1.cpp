#include <gtest/gtest.h>
#include <vector>

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

}  // namespace
}  // namespace shapegauge

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/retrieval/distances/chi2.h"

namespace shapegauge {
namespace {

using Vector = std::vector<float>;

TEST(Chi2, WeighsDifferencesByTheirSum) {
  // (0.25^2 / 0.75 + 0.25^2 / 0.75) / 2, and 0 for the bin that is empty in both.
  EXPECT_NEAR(chi2_distance(Vector{0.5F, 0.25F, 0, 0.25F}, Vector{0.25F, 0.5F, 0, 0.25F}), 1.0 / 12, 1e-15);
  EXPECT_EQ(chi2_distance(Vector{1, 0}, Vector{0, 1}), 1);
}

}  // namespace
}  // namespace shapegauge

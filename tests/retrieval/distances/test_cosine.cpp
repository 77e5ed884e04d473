#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/retrieval/distances/cosine.h"

namespace shapegauge {
namespace {

using Vector = std::vector<float>;

TEST(Cosine, MeasuresTheAngleOnly) {
  EXPECT_NEAR(cosine_distance(Vector{1, 0}, Vector{5, 5}), 1 - std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(cosine_distance(Vector{1, 0}, Vector{0, 3}), 1, 1e-15);
  EXPECT_NEAR(cosine_distance(Vector{1, 0}, Vector{-2, 0}), 2, 1e-15);
  EXPECT_EQ(cosine_distance(Vector{1, 2, 3}, Vector{2, 4, 6}), 0);
}

}  // namespace
}  // namespace shapegauge

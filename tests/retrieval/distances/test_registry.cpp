#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>
#include <vector>

#include "shapegauge/retrieval/distances/registry.h"

namespace shapegauge {
namespace {

std::vector<float> random_histogram(std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<float> histogram(12);
  for (float& bin : histogram) bin = std::max(0.0F, uniform(random) - 0.3F);
  histogram[0] += 0.01F;
  return histogram;
}

TEST(DistanceRegistry, NamesAreDifferent) {
  std::set<std::string_view> names;
  for (const NamedDistance& distance : distances()) names.insert(distance.name);
  EXPECT_EQ(names.size(), distances().size());
}

// What a distance matrix relies on.
TEST(DistanceRegistry, EveryDistanceIsSymmetricNotNegativeAndZeroForEqualSignatures) {
  std::mt19937 random(4);
  for (int i = 0; i < 50; ++i) {
    const std::vector<float> a = random_histogram(random);
    const std::vector<float> b = random_histogram(random);
    for (const NamedDistance& distance : distances()) {
      EXPECT_EQ(distance.function(a, a), 0) << distance.name;
      EXPECT_GT(distance.function(a, b), 0) << distance.name;
      EXPECT_NEAR(distance.function(a, b), distance.function(b, a), 1e-15) << distance.name;
    }
  }
}

}  // namespace
}  // namespace shapegauge

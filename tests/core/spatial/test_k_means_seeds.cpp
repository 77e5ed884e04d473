// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/spatial/k_means_seeds.h"

namespace shapegauge {
namespace {

std::vector<Eigen::Index> seeds_among(const Eigen::VectorXd& coordinates, Eigen::Index count, std::uint64_t seed) {
  RandomNumbers random(seed);
  return k_means_seeds(coordinates.size(), count, random, [&](Eigen::Index from) -> Eigen::VectorXd {
    return (coordinates.array() - coordinates[from]).square().matrix();
  });
}

TEST(KMeansSeeds, AreDistinctPositions) {
  const Eigen::VectorXd coordinates{{0, 0, 0, 5, 5, 9}};
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    std::vector<double> chosen;
    for (const Eigen::Index i : seeds_among(coordinates, 3, seed)) chosen.push_back(coordinates[i]);
    std::ranges::sort(chosen);
    EXPECT_EQ(chosen, (std::vector<double>{0, 5, 9})) << seed;
  }
}

TEST(KMeansSeeds, AreAtMostAsManyAsDistinctPoints) {
  EXPECT_EQ(seeds_among(Eigen::VectorXd{{0, 0, 5, 5}}, 4, 1).size(), 2U);
  EXPECT_EQ(seeds_among(Eigen::VectorXd{{7}}, 3, 1), std::vector<Eigen::Index>{0});
}

TEST(KMeansSeeds, AreDrawnInProportionToSquaredDistances) {
  // The first is 0 in a third of the cases. Then the second is at 1 with 1 / 10, and at 3 with 9 / 10.
  const Eigen::VectorXd coordinates{{0, 1, 3}};
  int first = 0;
  int far = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    const std::vector<Eigen::Index> chosen = seeds_among(coordinates, 2, seed);
    if (chosen[0] != 0) continue;
    ++first;
    far += chosen[1] == 2 ? 1 : 0;
  }
  EXPECT_NEAR(first, 1000, 150);  // six standard deviations
  EXPECT_NEAR(static_cast<double>(far) / first, 0.9, 0.06);
}

}  // namespace
}  // namespace shapegauge

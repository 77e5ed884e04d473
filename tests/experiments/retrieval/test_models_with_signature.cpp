// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <limits>

#include "shapegauge/experiments/retrieval/models_with_signature.h"

namespace shapegauge {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<ModelFailure> second_of_three() { return {{.model = 1, .message = "no triangles"}}; }

DistanceMatrix with_infinite_second() {
  return DistanceMatrix{{0, infinite, 5}, {infinite, 0, infinite}, {7, infinite, 0}};
}

TEST(ModelsWithSignature, ModelsWithoutASignatureAreInfinitelyFar) {
  const ModelsWithSignature models(second_of_three(), 3);
  EXPECT_FALSE(models.has_all_models());
  EXPECT_THAT(models.indices(), testing::ElementsAre(0, 2));
  const DistanceMatrix between{{0, 5}, {7, 0}};
  EXPECT_EQ(models.spread(between), with_infinite_second());
}

TEST(ModelsWithSignature, DistancesOfModelsWithoutASignatureBecomeInfiniteInBlocksOfRows) {
  const ModelsWithSignature models(second_of_three(), 3);
  const DistanceMatrix whole{{0, 1, 5}, {2, 0, 3}, {7, 4, 0}};
  DistanceMatrix first = whole.topRows(1);
  DistanceMatrix others = whole.bottomRows(2);
  models.set_infinite(first, 0);
  models.set_infinite(others, 1);
  EXPECT_EQ(first, with_infinite_second().topRows(1));
  EXPECT_EQ(others, with_infinite_second().bottomRows(2));
}

TEST(ModelsWithSignature, DistancesAreUnchangedIfAllModelsHaveASignature) {
  const ModelsWithSignature models({}, 2);
  EXPECT_TRUE(models.has_all_models());
  const DistanceMatrix between = DistanceMatrix::Random(2, 2);
  EXPECT_EQ(models.spread(between), between);
}

TEST(ModelsWithSignature, MissingSignaturesAreReplacedByTheFirstExistingSignature) {
  const Signatures all{{1, 2}, {3, 4}, {5, 6}, {7, 8}};
  const std::vector<ModelFailure> without{{.model = 0, .message = ""}, {.model = 3, .message = ""}};
  const Signatures expected{{3, 4}, {3, 4}, {5, 6}, {3, 4}};
  EXPECT_EQ(ModelsWithSignature(without, 4).with_placeholder_rows(all), expected);
}

}  // namespace

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/tools/part_model_training.h"

namespace shapegauge {
namespace {

/// Pairs with random features, in the same part if the first two have equal signs: not linearly separable.
std::vector<PartExample> examples(int count, std::uint64_t seed) {
  RandomNumbers random(seed);
  std::vector<PartExample> result(static_cast<std::size_t>(count));
  for (PartExample& example : result) {
    for (double& x : example.features) x = random.uniform(-1, 1);
    example.together = example.features[0] * example.features[1] > 0 ? 1 : 0;
    example.weight = 1;
  }
  return result;
}

TEST(PartModelTraining, LearnsANonlinearFunction) {
  const PartModel model = train_part_model(examples(4000, 1), {.networks = 2, .epochs = 40});
  int right = 0;
  const std::vector<PartExample> others = examples(1000, 2);
  for (const PartExample& example : others) {
    right += (model.probability(example.features) > 0.5) == (example.together > 0.5) ? 1 : 0;
  }
  EXPECT_GT(right, 750);  // a linear model is right for half of them
}

TEST(PartModelTraining, FirstStepHasTheLengthOfTheLearningRate) {
  // Adam's corrected moments of one gradient are the gradient and its square: the step is the rate, whatever its
  // length. One batch, an epoch of two: half of the rate of the cosine.
  const std::vector<PartExample> batch = examples(200, 1);
  const double rate = 0.01;
  const PartModel once = train_part_model(batch, {.networks = 1, .epochs = 1, .rate = rate});
  const PartModel twice = train_part_model(batch, {.networks = 1, .epochs = 2, .rate = rate});
  EXPECT_EQ(once.output_bias, 0);  // the rate ends at 0
  EXPECT_NEAR(std::abs(twice.output_bias), rate / 2, 1e-4 * rate);
}

TEST(PartModelTraining, LearnsTargetProbabilitiesBetweenZeroAndOne) {
  std::vector<PartExample> same = examples(500, 1);
  for (PartExample& example : same) example.together = 0.3;
  EXPECT_NEAR(train_part_model(same, {.epochs = 100}).probability(same[0].features), 0.3, 0.05);
}

TEST(PartModelTraining, GivesTheSameModelForTheSameExamples) {
  const PartModel first = train_part_model(examples(500, 1), {});
  const PartModel second = train_part_model(examples(500, 1), {});
  EXPECT_EQ(first.hidden, second.hidden);
  EXPECT_EQ(first.output_bias, second.output_bias);
}

TEST(PartModelTraining, RejectsAnEmptyTrainingSet) {
  EXPECT_THROW(train_part_model({}, {}), ArgumentError);
  EXPECT_THROW(train_part_model(examples(5, 1), {.hidden_units = 0}), ArgumentError);
}

TEST(PartExamples, CountPairsInTheSamePartAveragedOverHumanSegmentations) {
  const std::vector<std::int32_t> patch = {0, 0, 1, 1, 1};
  const Eigen::MatrixXd together = pairs_together(patch, 2, {{7, 7, 7, 7, 9}, {1, 2, 2, 2, 2}});
  EXPECT_DOUBLE_EQ(together(0, 1), (4 + 3) / 2.0);
  EXPECT_DOUBLE_EQ(together(1, 0), together(0, 1));
  EXPECT_DOUBLE_EQ(together(0, 0), (2 + 0) / 2.0);
  EXPECT_DOUBLE_EQ(together(1, 1), (2 + 6) / 2.0);
}

TEST(PartExamples, AreRecordedAtEachMergeOfTwoRegions) {
  // Four regions of one node in a row; the human segmentation joins 0 with 1 and 2 with 3.
  Regions regions(4);
  for (std::int32_t i = 0; i < 4; ++i) {
    RegionSum sum;
    sum.nodes = 1;
    sum.area = 0.25;
    regions.add(i, sum);
    if (i > 0) regions.make_neighbours(i - 1, i);
  }
  const std::vector<std::int32_t> patch = {0, 1, 2, 3};
  const std::vector<PartExample> met = part_examples(regions, pairs_together(patch, 4, {{0, 0, 1, 1}}), nullptr);
  std::vector<double> shares;
  double weights = 0;
  for (const PartExample& example : met) {
    shares.push_back(example.together);
    weights += example.weight;
  }
  EXPECT_EQ(shares, (std::vector<double>{1, 0, 1, 0, 0}));
  EXPECT_NEAR(weights, 1, 1e-12);
}

}  // namespace
}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <vector>

#include "shapegauge/experiments/segmentation/part_consistency.h"

namespace shapegauge {

namespace {

/// Results of a method "m" on shapes of the given classes, with parts of the given sizes.
SegmentationResults results_of(const std::vector<int>& labels, const std::vector<std::vector<double>>& sizes) {
  SegmentationResults results;
  results.experiment.methods.resize(1);
  results.experiment.methods[0].name = "m";
  results.scores.classes = {"a", "b"};
  results.scores.labels = labels;
  for (const std::vector<double>& of_shape : sizes) {
    results.shapes.emplace_back();
    results.shapes.back().part_sizes = {of_shape};
  }
  return results;
}

TEST(PartConsistency, ComparesSortedPartSizesAndIgnoresTinyPartsInCounts) {
  SegmentationResults results = results_of({0, 0, 0}, {{0.6, 0.4}, {0.5, 0.495, 0.005}, {0.7, 0.2, 0.1}});
  results.scores.classes = {"a"};
  // Differences: (0.1 + 0.095 + 0.005) / 2, (0.1 + 0.2 + 0.1) / 2, (0.2 + 0.295 + 0.095) / 2.
  EXPECT_THAT(consistency_table(results).rows.front(),
              testing::ElementsAre("m", "a", "2.000", "0.333", fmt::format("{:.3f}", (0.1 + 0.2 + 0.295) / 3), "-"));
}

TEST(PartConsistency, ComparesShapesWithinClassesAndAveragesOverClasses) {
  const SegmentationResults results = results_of({0, 0, 1}, {{0.5, 0.5}, {0.5, 0.5}, {1.0}});
  const TextTable table = consistency_table(results);
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_THAT(table.rows[0], testing::ElementsAre("m", "a", "2.000", "1.000", "0.000", "0.500"));
  EXPECT_THAT(table.rows[1], testing::ElementsAre("m", "b", "1.000", "-", "-", "0.500"));
  EXPECT_THAT(table.rows[2], testing::ElementsAre("m", "mean", "1.500", "1.000", "0.000", "0.500"));
}

TEST(PartConsistency, MedianPartCountOfTwoShapesIsTheirMean) {
  const SegmentationResults results = results_of({0, 0}, {{1.0}, {0.4, 0.3, 0.2, 0.1}});
  EXPECT_EQ(consistency_table(results).rows[0][2], "2.500");
}

TEST(PerturbationTable, HasOneRowPerMethodWithPerturbations) {
  SegmentationResults results = results_of({0, 0, 0}, {{1.0}, {1.0}, {1.0}});
  for (std::size_t i = 0; i < 3; ++i) results.shapes[i].perturbation_errors = {std::vector{0.1, 0.5, 0.3}[i]};
  EXPECT_TRUE(perturbation_effect_table(results).rows.empty());
  results.experiment.methods[0].perturbations.push_back({.values = ParameterValues({})});
  ASSERT_EQ(perturbation_effect_table(results).rows.size(), 1U);
  EXPECT_THAT(perturbation_effect_table(results).rows[0], testing::ElementsAre("m", "0.300", "0.300", "0.500"));
}

}  // namespace

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/results/thickness_summary.h"

namespace shapegauge {
namespace {

ScalarField field_of(std::vector<double> values, std::vector<double> weights) {
  return {.values = Eigen::Map<Eigen::VectorXd>(values.data(), std::ssize(values)),
          .weights = Eigen::Map<Eigen::VectorXd>(weights.data(), std::ssize(weights))};
}

const double none = std::numeric_limits<double>::quiet_NaN();

TEST(ThicknessSummary, WeighsValuesByArea) {
  // Area fractions: 0.1 with value 1, 0.4 with 2, 0.5 with 4; 9 has weight 0, and one sample has no value.
  const ThicknessSummary summary = summarise(field_of({4, 1, none, 2, 9}, {5, 1, 100, 4, 0}), 2.0);
  EXPECT_EQ(summary.samples, 5U);
  EXPECT_EQ(summary.missing, 1U);
  EXPECT_DOUBLE_EQ(summary.area, 10);
  EXPECT_DOUBLE_EQ(summary.least, 1);
  EXPECT_DOUBLE_EQ(summary.greatest, 4);
  EXPECT_DOUBLE_EQ(summary.mean, 2.9);
  EXPECT_THAT(summary.percentiles, testing::ElementsAre(1, 1, 2, 2, 4, 4, 4));
  EXPECT_DOUBLE_EQ(*summary.area_below, 1) << "2 is not below 2";
}

TEST(ThicknessSummary, IsEmptyWithoutValues) {
  const ThicknessSummary summary = summarise(field_of({none}, {1}));
  EXPECT_EQ(summary.missing, 1U);
  EXPECT_TRUE(std::isnan(summary.mean));
  EXPECT_FALSE(summary.area_below);
  const NamedSummary named{.name = "x.stl", .summary = summarise(field_of({none}, {1}), 1.0)};
  EXPECT_TRUE(summary_json(named, {.threshold = 1.0})["below"]["percent"].is_null());
}

TEST(ThicknessSummary, IsWrittenAsTableAndJson) {
  const std::vector<NamedSummary> one{{.name = "x.stl", .summary = summarise(field_of({1, 3}, {1, 3}), 2.0)}};
  const SummaryWords words{.unit = "mm", .threshold = 2.0};
  const TextTable table = thickness_summary_table(one, words);
  ASSERT_EQ(table.rows.size(), 1U);
  ASSERT_EQ(table.rows[0].size(), table.header.size());
  EXPECT_EQ(table.header.back(), "area below 2mm (%)");
  EXPECT_EQ(table.rows[0].back(), "25.00");
  EXPECT_EQ(table.rows[0][4], "1");
  const nlohmann::ordered_json json = summary_json(one[0], words);
  EXPECT_EQ(json["unit"], "mm");
  EXPECT_EQ(json["percentiles"]["50"], 3);
  EXPECT_EQ(json["below"]["percent"], 25);
  EXPECT_EQ(thickness_summary_table(one, {}).header[4], "min");
}

}  // namespace
}  // namespace shapegauge

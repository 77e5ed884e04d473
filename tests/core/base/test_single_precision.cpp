// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/base/single_precision.h"

namespace shapegauge {

namespace {

TEST(RowsMergedInSinglePrecision, CountsRowsMadeEqualByRounding) {
  const std::vector<double> far{1e9, 0, 1e9 + 1, 0, 1e9 + 2, 0, 1e9 + 1, 0, 1e9 + 1000, 0};
  EXPECT_EQ(rows_merged_in_single_precision(far, 2), 2U) << "the first three values; the repeated one counts once";
  EXPECT_EQ(rows_merged_in_single_precision(std::vector<double>{1e-46, 2e-46, -1e-46, 0}, 1), 3U);
}

TEST(RowsMergedInSinglePrecision, IgnoresRowsThatStayDistinctOrWereEqualBeforeRounding) {
  EXPECT_EQ(rows_merged_in_single_precision(std::vector<double>{0.1, 0.2, 0.3, 0.1, 0.2, 0.4}, 3), 0U);
  EXPECT_EQ(rows_merged_in_single_precision(std::vector<double>{0.1, 0.2, 0.1, 0.2}, 2), 0U);
  EXPECT_EQ(rows_merged_in_single_precision(std::vector<double>{0.0, -0.0, 1e-46}, 1), 1U);
  EXPECT_EQ(rows_merged_in_single_precision({}, 0), 0U);
}

}  // namespace

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/base/median.h"
#include "shapegauge/core/base/random_numbers.h"

namespace shapegauge {

namespace {

TEST(Median, IsTheMiddleOfSortedNumbers) {
  EXPECT_EQ(sorted_median(std::vector<double>{4}), 4);
  EXPECT_EQ(sorted_median(std::vector<double>{1, 4}), 2.5);
  EXPECT_EQ(sorted_median(std::vector<double>{1, 4, 9}), 4);
  EXPECT_EQ(sorted_median(std::vector<double>{1, 4, 9, 100}), 6.5);
}

TEST(Median, UpperMedianIsTheUpperMiddleElementAfterSorting) {
  RandomNumbers random(1);
  for (std::size_t count = 1; count < 50; ++count) {
    std::vector<double> values(count);
    for (double& value : values) value = static_cast<double>(random.below(20));
    std::vector<double> sorted = values;
    std::ranges::sort(sorted);
    EXPECT_EQ(upper_median(values), sorted[count / 2]) << count;
    std::ranges::sort(values);
    EXPECT_EQ(values, sorted) << "reordered only";
  }
}

}  // namespace

}  // namespace shapegauge

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <vector>

#include "shapegauge/core/sdf/mean_without_outliers.h"

namespace shapegauge {
namespace {

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

/// The definition, word by word; sums from the smallest to the largest.
double defined_mean(std::vector<double> values) {
  std::ranges::sort(values);
  const double centre = median(values);
  std::vector<double> deviations;
  for (const double value : values) deviations.push_back(std::abs(value - centre));
  const double limit = 1.5 * median(deviations);
  double sum = 0;
  int count = 0;
  for (const double value : values) {
    if (std::abs(value - centre) > limit) continue;
    sum += value;
    ++count;
  }
  return sum / count;
}

double mean_of(std::vector<double> values) { return mean_without_outliers(values); }

TEST(MeanWithoutOutliers, LeavesOutWhatIsFarFromTheMedian) {
  EXPECT_EQ(mean_of({4}), 4);
  EXPECT_EQ(mean_of({1, 3}), 2);
  EXPECT_EQ(mean_of({5, 2, 2, 2}), 2);
  EXPECT_EQ(mean_of({1, 9, 3, 2, 100}), 2);       // median 3, deviations 0 1 2 6 97, limit 3
  EXPECT_EQ(mean_of({10, 2, 3, 5, 90, 4}), 3.5);  // median 4.5, deviations .5 .5 1.5 2.5 5.5 85.5, limit 3
}

/// Values of a few kinds, so that many are equal, or any at all.
RC_GTEST_PROP(MeanWithoutOutliers, IsTheDefinition, (bool many_equal)) {
  const int count = *rc::gen::inRange(1, 200);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    values.push_back(*rc::gen::inRange(0, many_equal ? 6 : 1'000'000) / 7.0);
  }
  const double expected = defined_mean(values);
  RC_ASSERT(mean_without_outliers(values) == expected);
  RC_ASSERT(std::ranges::is_sorted(values));
}

}  // namespace
}  // namespace shapegauge

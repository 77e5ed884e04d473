// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/studentised_range.h"

namespace shapegauge {

namespace {

TEST(StudentisedRange, OfTwoGroupsMatchesTheNormalDistribution) {
  // The difference of two standard normal values has the standard deviation sqrt(2).
  for (const double range : {0.1, 1.0, 2.0, 3.5, 6.0}) {
    EXPECT_NEAR(studentised_range_probability(range, 2), std::erf(range / 2), 1e-12);
  }
  EXPECT_NEAR(studentised_range_quantile(0.05, 2), std::sqrt(2.0) * 1.959963984540054, 1e-9);
}

TEST(StudentisedRange, QuantilesMatchPublishedCriticalValues) {
  // Demsar 2006, table 5(a): critical values of Nemenyi's test, q / sqrt(2), for 2 to 10 methods.
  const double at_5_percent[] = {1.960, 2.343, 2.569, 2.728, 2.850, 2.949, 3.031, 3.102, 3.164};
  const double at_10_percent[] = {1.645, 2.052, 2.291, 2.459, 2.589, 2.693, 2.780, 2.855, 2.920};
  for (std::size_t count = 2; count <= 10; ++count) {
    EXPECT_NEAR(studentised_range_quantile(0.05, count) / std::sqrt(2.0), at_5_percent[count - 2], 0.00101) << count;
    EXPECT_NEAR(studentised_range_quantile(0.10, count) / std::sqrt(2.0), at_10_percent[count - 2], 0.00101) << count;
  }
}

TEST(StudentisedRange, QuantileInvertsTheProbabilityForManyGroups) {
  for (const std::size_t count : {3U, 30U, 300U}) {
    for (const double alpha : {1e-6, 0.01, 0.5, 0.99}) {
      EXPECT_NEAR(1 - studentised_range_probability(studentised_range_quantile(alpha, count), count), alpha, 1e-10);
    }
  }
}

TEST(StudentisedRange, ProbabilityRunsFromZeroToOneAndRequiresTwoGroups) {
  EXPECT_EQ(studentised_range_probability(0, 5), 0);
  EXPECT_EQ(studentised_range_probability(-1, 5), 0);
  EXPECT_EQ(studentised_range_probability(std::numeric_limits<double>::infinity(), 5), 1);
  EXPECT_NEAR(studentised_range_probability(20, 5), 1, 1e-12);
  EXPECT_THROW(studentised_range_probability(1, 1), ArgumentError);
  EXPECT_THROW(studentised_range_probability(std::nan(""), 3), ArgumentError);
  EXPECT_THROW(studentised_range_quantile(0, 3), ArgumentError);
  EXPECT_THROW(studentised_range_quantile(1, 3), ArgumentError);
}

}  // namespace

}  // namespace shapegauge

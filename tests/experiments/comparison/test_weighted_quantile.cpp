#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

#include "shapegauge/experiments/comparison/weighted_quantile.h"

namespace shapegauge {
namespace {

TEST(WeightedQuantile, IsTheLeastValueWithThatShareOfTheWeight) {
  const Eigen::VectorXd values = Eigen::Vector4d(7, 1, 5, 3);
  const Eigen::VectorXd once = Eigen::VectorXd::Ones(4);
  EXPECT_EQ(weighted_quantile(values, once, 0.5), 3);
  EXPECT_EQ(weighted_quantile(values, once, 0.51), 5);
  EXPECT_EQ(weighted_quantile(values, once, 1), 7);
  EXPECT_EQ(weighted_quantile(values, Eigen::Vector4d(10, 1, 1, 1), 0.5), 7);
  EXPECT_EQ(weighted_quantile(values, Eigen::Vector4d(1, 0, 1, 0), 0), 5) << "what has no weight is no answer";
}

TEST(WeightedQuantile, OfNothingIsNotANumber) {
  EXPECT_TRUE(std::isnan(weighted_quantile({}, {}, 0.5)));
  EXPECT_TRUE(std::isnan(weighted_quantile(Eigen::Vector2d(1, 2), Eigen::Vector2d(0, 0), 0.5)));
  EXPECT_THROW(weighted_quantile(Eigen::Vector2d(1, 2), Eigen::VectorXd::Ones(3), 0.5), std::invalid_argument);
}

}  // namespace
}  // namespace shapegauge

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

#include "shapegauge/metrics/statistics/effect_size.h"

namespace shapegauge {
namespace {

TEST(EffectSize, IsTheMeanInStandardDeviations) {
  // Mean 2, squared deviations 1 + 0 + 1, over n - 1 = 2: a standard deviation of 1.
  EXPECT_DOUBLE_EQ(effect_size((Eigen::VectorXd(3) << 1, 2, 3).finished()), 2);
  EXPECT_EQ(effect_size(Eigen::VectorXd::Zero(3)), 0);
  EXPECT_TRUE(std::isinf(effect_size(Eigen::VectorXd::Ones(3))));
  EXPECT_THROW(effect_size(Eigen::VectorXd::Ones(1)), std::invalid_argument);
}

}  // namespace
}  // namespace shapegauge

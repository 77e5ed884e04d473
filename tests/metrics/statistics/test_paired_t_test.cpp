#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

#include "shapegauge/metrics/statistics/paired_t_test.h"

namespace shapegauge {
namespace {

// "Student"'s own data, Biometrika 1908: hours of sleep gained by one drug over another. t = 4.06 with 9 degrees of
// freedom, p = 0.00283.
TEST(PairedTTest, StudentsSleep) {
  const Eigen::VectorXd gained = (Eigen::VectorXd(10) << 1.2, 2.4, 1.3, 1.3, 0, 1, 1.8, 0.8, 4.6, 1.4).finished();
  const PairedT result = paired_t_test(gained);
  EXPECT_NEAR(result.t, 4.0621, 5e-5);
  EXPECT_EQ(result.degrees_of_freedom, 9);
  EXPECT_NEAR(result.p, 0.002833, 5e-7);
  EXPECT_DOUBLE_EQ(paired_t_test(-gained).p, result.p);
}

TEST(PairedTTest, DifferencesThatDoNotVary) {
  EXPECT_EQ(paired_t_test(Eigen::VectorXd::Zero(5)).p, 1);
  EXPECT_EQ(paired_t_test(Eigen::VectorXd::Constant(4, -0.5)).p, 0);
  EXPECT_TRUE(std::isinf(paired_t_test(Eigen::VectorXd::Constant(4, -0.5)).t));
}

TEST(PairedTTest, NeedsTwo) { EXPECT_THROW(paired_t_test(Eigen::VectorXd::Ones(1)), std::invalid_argument); }

}  // namespace
}  // namespace shapegauge

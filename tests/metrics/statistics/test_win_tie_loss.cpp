#include <gtest/gtest.h>

#include "shapegauge/metrics/statistics/win_tie_loss.h"

namespace shapegauge {
namespace {

TEST(WinTieLoss, CountsSigns) {
  const WinTieLoss counts = win_tie_loss((Eigen::VectorXd(6) << 1, 0, -2, 0.5, 0, 3).finished());
  EXPECT_EQ(counts.wins, 3);
  EXPECT_EQ(counts.ties, 2);
  EXPECT_EQ(counts.losses, 1);
}

}  // namespace
}  // namespace shapegauge

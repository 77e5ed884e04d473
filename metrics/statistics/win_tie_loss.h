#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// On how many queries the first of two methods has the larger value, the same value, the smaller one.
struct WinTieLoss {
  Eigen::Index wins = 0;
  Eigen::Index ties = 0;
  Eigen::Index losses = 0;
};

/// Counts by the sign of the differences, first method minus second.
WinTieLoss win_tie_loss(const Eigen::VectorXd& differences);

}  // namespace shapegauge

#include "shapegauge/metrics/statistics/win_tie_loss.h"

namespace shapegauge {

WinTieLoss win_tie_loss(const Eigen::VectorXd& differences) {
  return {.wins = (differences.array() > 0).count(),
          .ties = (differences.array() == 0).count(),
          .losses = (differences.array() < 0).count()};
}

}  // namespace shapegauge

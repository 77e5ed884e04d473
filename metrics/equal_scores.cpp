// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/equal_scores.h"

#include "shapegauge/metrics/ascending_order.h"

namespace shapegauge {

Eigen::VectorXd score_differences(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.binaryExpr(b, [](double x, double y) { return are_equal_scores(x, y) ? 0.0 : x - y; });
}

std::vector<std::vector<std::size_t>> groups_of_equal_scores(const Eigen::VectorXd& scores) {
  const auto score = [&](std::size_t i) { return scores[static_cast<Eigen::Index>(i)]; };
  std::vector<std::vector<std::size_t>> groups;
  double best_of_group = 0;
  for (const std::size_t i : ascending_order(-scores)) {
    if (groups.empty() || !are_equal_scores(best_of_group, score(i))) {
      groups.emplace_back();
      best_of_group = score(i);
    }
    groups.back().push_back(i);
  }
  for (std::vector<std::size_t>& group : groups) std::ranges::sort(group);
  return groups;
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shapegauge {

/// Relative difference up to which scores are equal. Averages of equal counts differ by the rounding of their sums.
inline constexpr double score_rounding = 1e-12;

/// Returns true if the scores are equal up to rounding. All ranks, wins and ties are made by this comparison.
inline bool are_equal_scores(double a, double b) {
  return std::abs(a - b) <= score_rounding * std::max(std::abs(a), std::abs(b));
}

/// Returns a - b per query or unit; 0 for equal scores.
Eigen::VectorXd score_differences(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// Returns the indices of the scores in descending order. Equal scores form one group, in their own order.
std::vector<std::vector<std::size_t>> groups_of_equal_scores(const Eigen::VectorXd& scores);

}  // namespace shapegauge

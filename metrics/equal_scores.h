// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shapegauge {

/// Relative difference up to which two scores are equal. Averages that are equal in exact arithmetic may differ by the
/// rounding of sums.
inline constexpr double score_rounding = 1e-12;

/// Returns true if two scores are equal up to rounding (score_rounding). All ranks, wins and ties of methods use this
/// comparison.
inline bool are_equal_scores(double a, double b) {
  return std::abs(a - b) <= score_rounding * std::max(std::abs(a), std::abs(b));
}

/// Returns a[i] - b[i] for the scores a and b of two methods on each query or unit i; exactly 0 for scores that are
/// equal (are_equal_scores()).
Eigen::VectorXd score_differences(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// Groups equal scores (are_equal_scores()). Returns the indices of the scores of each group, ascending; the group of
/// the largest scores is first.
std::vector<std::vector<std::size_t>> groups_of_equal_scores(const Eigen::VectorXd& scores);

}  // namespace shapegauge

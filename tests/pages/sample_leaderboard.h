// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/pages/leaderboard_page.h"

namespace shapegauge::test_leaderboard {

/// Leaderboard, with the data it refers to.
struct SampleLeaderboard {
  std::vector<Evaluation> evaluations;
  LeaderboardPage page;
};

/// Thirty methods of decreasing quality on four classes, in overlapping groups, with names that need escaping in markup
/// and scripts; two submissions are rejected.
const SampleLeaderboard& sample_leaderboard();

}  // namespace shapegauge::test_leaderboard

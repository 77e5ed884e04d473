#pragma once

#include "shapegauge/pages/leaderboard_page.h"

namespace shapegauge::test_leaderboard {

/// A leaderboard, and what it points to.
struct SampleLeaderboard {
  std::vector<Evaluation> evaluations;
  LeaderboardPage page;
};

/// Thirty methods of falling quality on four classes, in groups that overlap, with names that a page of markup and
/// scripts could trip over; two submissions were refused.
const SampleLeaderboard& sample_leaderboard();

}  // namespace shapegauge::test_leaderboard

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "shapegauge/experiments/leaderboard/judge_submissions.h"

namespace shapegauge {

/// Replaces the repetitions of a method (Submission::repetition_of) by one submission with their mean evaluation and
/// the standard deviations of their averages. `scores` are by submission.
void combine_repetitions(std::vector<JudgedSubmission>& submissions, std::vector<MethodScores>& scores);

}  // namespace shapegauge

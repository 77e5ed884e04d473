// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "shapegauge/experiments/leaderboard/judge_submissions.h"

namespace shapegauge {

/// Combines the repetitions of each method (Submission::repetition_of) into one submission with the mean evaluation and
/// the standard deviations of the averages. `scores` has one entry per submission and is combined in the same way.
void combine_repetitions(std::vector<EvaluatedSubmission>& submissions, std::vector<MethodScores>& scores);

}  // namespace shapegauge

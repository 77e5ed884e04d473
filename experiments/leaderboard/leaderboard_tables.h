#pragma once

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/leaderboard/judge_submissions.h"
#include "shapegauge/experiments/results/evaluation_tables.h"

namespace shapegauge {

/// A row for each submission, the best first: rank, method, the measures averaged over queries; the best of each
/// measure is bold, and behind a score stand its letters (MethodStanding). With intervals in the cell of each score
/// where `intervals`.
Table leaderboard_table(const Leaderboard& board, const ScoreStyle& style, bool intervals = false);

/// For files: a row for each submission and average (micro, macro): rank, method, authors, paper, file, average, and
/// for each measure its value, the ends of its interval and its letters (NN, NN_low, NN_high, NN_group, ...); percent.
Table leaderboard_csv_table(const Leaderboard& board, const ScoreStyle& style = csv_style);

/// The same, the refused submissions and the settings as JSON, in fractions.
nlohmann::ordered_json leaderboard_json(const Leaderboard& board, const JudgingOptions& options);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/leaderboard/judge_submissions.h"
#include "shapegauge/experiments/results/evaluation_tables.h"

namespace shapegauge {

/// Makes a table with a row for each submission, best first: rank, method, measures averaged over queries. The best of
/// each measure is bold. Scores are followed by the letters of groups that do not differ significantly
/// (MethodStanding), in capitals for averages over classes, or by " ± " and their standard deviation over repetitions.
TextTable leaderboard_table(const Leaderboard& board, const ScoreStyle& style);

/// Makes a table for files with a row for each submission and average (micro, macro): rank, method, authors, paper,
/// file, average, and for each measure its value, the ends of its interval and its letters (NN, NN_low, NN_high,
/// NN_group, ...); percent. If a method has repetitions, also their standard deviations (NN_deviation, ...).
TextTable leaderboard_csv_table(const Leaderboard& board, const ScoreStyle& style = csv_style);

/// Returns a sentence that explains the letters of significance in a leaderboard.
std::string explain_letters(const StandingOptions& options);

/// Returns sentences that explain the confidence intervals, letters and test of a leaderboard.
std::string explain_significance(const Leaderboard& board, const StandingOptions& options);

/// Returns a warning if there are too few classes for significant differences between averages over classes (capital
/// letters); otherwise nothing.
std::optional<std::string> few_classes_warning(const Leaderboard& board, const StandingOptions& options);

/// Removes the paths of local folders, those of a submission and of the files of labels, from a text to be published.
std::string without_folders(std::string text, const std::filesystem::path& submission, const EvaluationFiles& files);

/// Formats the leaderboard, the refused submissions and the settings as JSON, with scores as fractions.
nlohmann::ordered_json leaderboard_json(const Leaderboard& board, const JudgingOptions& options);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/leaderboard/judge_submissions.h"
#include "shapegauge/experiments/results/evaluation_tables.h"

namespace shapegauge {

/// Makes a table with a row for each submission, best first: rank, method, measures averaged over queries. The best of
/// each measure is bold, and scores are followed by their letters over queries, and in capitals over classes
/// (MethodStanding), or by " ± " and their standard deviation over repetitions.
TextTable leaderboard_table(const Leaderboard& board, const ScoreStyle& style);

/// Makes a table for files with a row for each submission and average (micro, macro): rank, method, authors, paper,
/// file, average, and for each measure its value, the ends of its interval and its letters (NN, NN_low, NN_high,
/// NN_group, ...); percent. If a method has repetitions, also their standard deviations (NN_deviation, ...).
TextTable leaderboard_csv_table(const Leaderboard& board, const ScoreStyle& style = csv_style);

/// Explains the letters in a sentence.
std::string letter_words(const StandingOptions& options);

/// Explains intervals, letters and the test in sentences.
std::string significance_words(const Leaderboard& board, const StandingOptions& options);

/// Returns the warning that no two methods can have different capitals, since there are too few classes.
std::optional<std::string> few_classes_warning(const Leaderboard& board, const StandingOptions& options);

/// Returns a text for readers: without the folders of the submission and of the files of labels.
std::string without_folders(std::string text, const std::filesystem::path& submission, const EvaluationFiles& files);

/// Formats the leaderboard, the refused submissions and the settings as JSON, in fractions.
nlohmann::ordered_json leaderboard_json(const Leaderboard& board, const JudgingOptions& options);

}  // namespace shapegauge

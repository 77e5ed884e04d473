// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/experiments/evaluation/method_scores.h"
#include "shapegauge/experiments/leaderboard/submissions.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/method_standings.h"

namespace shapegauge {

/// Options for evaluating and ranking the submissions of a leaderboard.
struct JudgingOptions {
  EvaluationFiles files;         ///< labels or relevance judgements; `matrix` is unused, and the other settings are
                                 ///< defaults for submissions that do not set them
  EvaluationOptions evaluation;  ///< measures and other options of the evaluation
  StandingOptions standings;     ///< options of ranks and significance tests; macro averages are tested over classes
  std::string rank_by{};         ///< name of the measure to rank by; if empty, mAP or, if not computed, the first
  bool hide_classes = false;     ///< true to omit the classes of models from pages
};

/// File of one of several repetitions of a method (random seeds or folds).
struct RepetitionFile {
  std::filesystem::path file;  ///< file of the repetition, such as foo.seed1.npy
  std::string sha256;          ///< SHA-256 of the file
};

/// Evaluated submission. Repetitions of a method are combined into one: the first, with the mean evaluation of all.
struct EvaluatedSubmission {
  Submission submission;               ///< submission, with a name that is unique on the leaderboard
  EvaluationFiles files;               ///< files and settings of the evaluation
  std::string sha256;                  ///< SHA-256 of the submission's file
  std::string key;                     ///< cache key of the evaluation: hash of all its inputs
  Evaluation evaluation;               ///< scores of the submission, or their means over repetitions
  std::vector<std::string> query_ids;  ///< ids of the models in the rows of the matrix, or of ranked lists
  bool fit_for_report = false;         ///< true if a report can show it (is_fit_for_report()); false with repetitions
  std::vector<std::string> warnings;   ///< warnings for readers of the leaderboard, one sentence each
  std::vector<RepetitionFile> repetitions{};  ///< files of all repetitions; empty for a method with one file
  /// Standard deviation over repetitions of the micro (macro) average, one value per measure; empty for a single file.
  /// @{
  Eigen::VectorXd micro_deviation{};
  Eigen::VectorXd macro_deviation{};
  /// @}
};

/// Returns the scores of an evaluated submission for every query. `class_names` has the names by class index.
MethodScores scores_of(const EvaluatedSubmission& judged, const std::vector<std::string>& class_names);

/// Leaderboard: ranked submissions with their evaluations and standings, and refused submissions. Letters of
/// significance are capitals for tests over classes, lower case for tests over queries.
struct Leaderboard {
  std::vector<EvaluatedSubmission> submissions;    ///< submissions, best first by the ranking measure (over queries)
  std::vector<RefusedSubmission> refused;          ///< files that were refused, with the reasons
  std::vector<std::string> measures;               ///< names of the measures, such as "FT"
  std::size_t rank_by = 0;                         ///< index of the ranking measure in `measures`
  std::vector<std::string> class_names;            ///< names of the classes, by class index
  std::vector<int> labels;                         ///< class index of each target
  std::vector<std::vector<MethodStanding>> micro;  ///< per measure and submission: standing by averages over queries
  std::vector<std::vector<MethodStanding>> macro;  ///< per measure and submission: standing by averages over classes
};

/// Progress callback: receives the name of the current submission and the numbers of completed and of all submissions.
using JudgingProgress = std::function<void(const std::string& name, std::size_t done, std::size_t all)>;

/// Evaluates every submission separately, using the cache if the file, the labels and the options are unchanged, and
/// ranks the valid ones. A submission is refused if it cannot be read, does not match the labels, has a NaN distance,
/// or has other queries than the first valid one. It is also refused if it appears to mix up similarities and distances
/// and neither its JSON file nor the options specify which. Repetitions of a method are combined into one submission.
/// Queries without a ranked list count with scores of 0. The result also has the refused submissions of `found`. Throws
/// InputError if the measure to rank by is not computed, and if no submission is valid.
Leaderboard judge_submissions(const FoundSubmissions& found, const JudgingOptions& options, Cache& cache,
                              const JudgingProgress& progress = {});

}  // namespace shapegauge

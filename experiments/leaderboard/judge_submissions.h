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

/// Options of judging submissions, common to all of them.
struct JudgingOptions {
  EvaluationFiles files;  ///< labels or judgements; `matrix` is unused, and the other settings are defaults for
                          ///< submissions that do not set them
  EvaluationOptions evaluation;
  StandingOptions standings;  ///< of averages over queries; those over classes are tested over classes
  std::string rank_by{};      ///< measure; if empty, mAP or, without it, the first one
  bool hide_classes = false;  ///< omit classes of models from pages
};

/// File of one of several repetitions of a method.
struct RepetitionFile {
  std::filesystem::path file;
  std::string sha256;
};

/// Evaluated submission. Repetitions of a method are one: the first, with the mean evaluation of all.
struct JudgedSubmission {
  Submission submission;  ///< with a unique name
  EvaluationFiles files;  ///< as evaluated
  std::string sha256;     ///< of the file
  std::string key;        ///< of everything that the evaluation depends on
  Evaluation evaluation;
  std::vector<std::string> query_ids;         ///< per row
  bool fit_for_report = false;                ///< see is_fit_for_report()
  std::vector<std::string> warnings;          ///< for readers, one sentence each
  std::vector<RepetitionFile> repetitions{};  ///< empty for a single file
  /// Standard deviation of the averages over the repetitions, by measure; empty for a single file.
  /// @{
  Eigen::VectorXd micro_deviation{};
  Eigen::VectorXd macro_deviation{};
  /// @}
};

/// Returns the scores of an evaluated submission.
MethodScores scores_of(const JudgedSubmission& judged, const std::vector<std::string>& class_names);

/// Submissions with their evaluations and standings.
struct Leaderboard {
  std::vector<JudgedSubmission> submissions;  ///< best first, by `rank_by` averaged over queries
  std::vector<RefusedSubmission> refused;
  std::vector<std::string> measures;
  std::size_t rank_by = 0;                         ///< index of a measure
  std::vector<std::string> class_names;            ///< per class
  std::vector<int> labels;                         ///< class of each target
  std::vector<std::vector<MethodStanding>> micro;  ///< per measure, by submission: averages over queries
  std::vector<std::vector<MethodStanding>> macro;  ///< averages over classes, with capital letters
};

/// Receives the current submission and the progress.
using JudgingProgress = std::function<void(const std::string& name, std::size_t done, std::size_t all)>;

/// Evaluates every submission on its own, using the cache if it, the labels and the options are unchanged, and ranks
/// the valid ones. A submission is refused if it cannot be read, does not match the labels, has a NaN distance, or has
/// other queries than the first valid one. It is also refused if it appears to mix up similarities and distances and
/// neither its JSON file nor the options specify which. Repetitions of a method are combined to one submission. Queries
/// without a ranked list count with scores of 0. Appends to the refused ones of `found`. Throws InputError if the
/// measure to rank by is not computed, and if no submission is valid.
Leaderboard judge_submissions(const FoundSubmissions& found, const JudgingOptions& options, Cache& cache,
                              const JudgingProgress& progress = {});

}  // namespace shapegauge

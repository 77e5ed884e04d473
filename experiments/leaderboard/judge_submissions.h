#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/experiments/evaluation/method_scores.h"
#include "shapegauge/experiments/leaderboard/submissions.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/method_standings.h"

namespace shapegauge {

/// How submissions are judged; all of them alike.
struct JudgingOptions {
  EvaluationFiles
      files;  ///< labels or judgements; `matrix` is not used, the others hold where a submission says nothing
  EvaluationOptions evaluation;
  StandingOptions standings;  ///< the average is not used: both are computed
  std::string rank_by{};      ///< a measure; empty: mAP, or the first one where that is not among them
};

/// A submission that could be judged.
struct JudgedSubmission {
  Submission submission;  ///< with a name that no other has
  EvaluationFiles files;  ///< as it was judged
  std::string sha256;     ///< of the file
  Evaluation evaluation;
  std::vector<std::string> query_ids;  ///< by row
  bool fit_for_report = false;         ///< see is_fit_for_report()
  std::vector<std::string> warnings;   ///< what a reader should know of it, a sentence each
};

/// Submissions and what they are worth.
struct Leaderboard {
  std::vector<JudgedSubmission> submissions;  ///< the best by `rank_by`, averaged over queries, first
  std::vector<RefusedSubmission> refused;
  std::vector<std::string> measures;
  std::size_t rank_by = 0;                         ///< index of a measure
  std::vector<std::string> class_names;            ///< by class
  std::vector<int> labels;                         ///< class of each model to be found
  std::vector<std::vector<MethodStanding>> micro;  ///< by measure, by submission: averages over queries
  std::vector<std::vector<MethodStanding>> macro;  ///< so too: averages over classes
};

/// Told which submission of how many is being judged.
using JudgingProgress = std::function<void(const std::string& name, std::size_t done, std::size_t all)>;

/// Judges every submission by itself, from the cache where it, the labels and the options are as they were before, and
/// ranks those that can be judged. A submission is refused where it cannot be read, does not fit the labels, holds a
/// distance that is NaN, has other queries than the first one that was judged, or looks like similarities given as
/// distances or the other way round and neither its JSON nor the options say which. Queries without a ranked list count
/// with scores of 0. Adds to the refused ones of `found`. Throws InputError where a measure to rank by is not among the
/// measures, and where no submission can be judged.
Leaderboard judge_submissions(const FoundSubmissions& found, const JudgingOptions& options, Cache& cache,
                              const JudgingProgress& progress = {});

}  // namespace shapegauge

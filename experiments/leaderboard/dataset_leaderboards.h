// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/leaderboard/judge_submissions.h"
#include "shapegauge/experiments/results/multi_dataset_results.h"

namespace shapegauge {

/// Data set of a leaderboard: a folder with its submissions and its labels.
struct SubmittedDataset {
  std::string name;  ///< of the folder
  std::filesystem::path folder;
  EvaluationFiles files;  ///< with the files of the folder
};

/// Finds data sets. Each folder has a file `labels.*` and optionally `targets.*` and `ids.*`, or `qrels.*`. `common`
/// are other settings. Throws InputError for a path that is not a folder, a folder without labels or with several files
/// of labels, two folders of one name, and for labels and judgements in different folders.
std::vector<SubmittedDataset> find_submitted_datasets(std::span<const std::filesystem::path> folders,
                                                      const EvaluationFiles& common);

/// Leaderboards of several data sets.
struct DatasetLeaderboards {
  std::vector<SubmittedDataset> datasets;
  std::vector<Leaderboard> boards;             ///< by data set
  MultiDatasetResults results;                 ///< of the methods that all data sets have
  std::vector<RefusedSubmission> refused;      ///< with one of each method that a data set lacks
  std::vector<std::filesystem::path> skipped;  ///< see FoundSubmissions
};

/// Evaluates the submissions for each data set, see judge_submissions(), and compares the methods over all data sets by
/// ranks. Methods are matched by their names; one that a data set lacks is refused. The labels in `options` are
/// ignored. Throws InputError as judge_submissions() does, and if no method has submissions for all data sets.
DatasetLeaderboards judge_datasets(const std::vector<SubmittedDataset>& datasets, const JudgingOptions& options,
                                   Cache& cache, const JudgingProgress& progress = {});

/// Formats the comparison, the refused submissions and the settings as JSON, in fractions.
nlohmann::ordered_json dataset_leaderboards_json(const DatasetLeaderboards& all, const JudgingOptions& options);

}  // namespace shapegauge

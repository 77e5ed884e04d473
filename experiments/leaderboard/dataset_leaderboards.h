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
  std::string name;              ///< name of the data set, equal to the folder's name
  std::filesystem::path folder;  ///< folder with the submissions and the labels
  EvaluationFiles files;         ///< labels or relevance judgements of the data set, and how files are read
};

/// Finds the data sets of a leaderboard, one per folder. Each folder has a file `labels.*` and optionally `targets.*`
/// and `ids.*`, or `qrels.*`. `common` has the settings and files that all data sets share. Throws InputError for a
/// path that is not a folder, a folder without labels or with several files of labels, two folders of one name, and for
/// labels and judgements in different folders.
std::vector<SubmittedDataset> find_submitted_datasets(std::span<const std::filesystem::path> folders,
                                                      const EvaluationFiles& common);

/// Leaderboards of several data sets, and the comparison of methods over all of them.
struct DatasetLeaderboards {
  std::vector<SubmittedDataset> datasets;      ///< data sets with their submissions and labels
  std::vector<Leaderboard> boards;             ///< one leaderboard per data set
  MultiDatasetResults results;                 ///< ranks and tests of the methods with submissions for all data sets
  std::vector<RefusedSubmission> refused;      ///< refused files, also of methods that lack a file for some data set
  std::vector<std::filesystem::path> skipped;  ///< files that are no submissions (FoundSubmissions::skipped)
};

/// Evaluates the submissions for each data set, see judge_submissions(), and compares the methods over all data sets by
/// ranks. Methods are matched by their names; a method without a valid submission for every data set is refused. The
/// labels in `options` are ignored. Throws InputError as judge_submissions() does, and if no method has submissions for
/// all data sets.
DatasetLeaderboards evaluate_datasets(const std::vector<SubmittedDataset>& datasets, const JudgingOptions& options,
                                      Cache& cache, const JudgingProgress& progress = {});

/// Formats the comparison over data sets, the refused submissions and the settings as JSON, with scores as fractions.
nlohmann::ordered_json dataset_leaderboards_json(const DatasetLeaderboards& all, const JudgingOptions& options);

}  // namespace shapegauge

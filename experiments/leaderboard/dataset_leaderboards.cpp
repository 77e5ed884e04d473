// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/leaderboard/dataset_leaderboards.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/leaderboard/leaderboard_tables.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

// Returns the file of a folder whose name is `stem` and any extensions; an empty path if there is none.
fs::path only_file(const fs::path& folder, std::string_view stem) {
  fs::path found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.substr(0, name.find('.')) != stem || is_folder(entry.path())) continue;
    if (!found.empty()) {
      throw InputError(fmt::format("{}: has the files {} and {}; remove one", folder.string(),
                                   std::min(name, found.filename().string()),
                                   std::max(name, found.filename().string())));
    }
    found = entry.path();
  }
  return found;
}

SubmittedDataset submitted_dataset(const fs::path& folder, const EvaluationFiles& common) {
  if (!is_folder(folder)) {
    throw InputError(
        fmt::format("{}: not a folder; give `labels` or `qrels`, or folders of data sets with a file "
                    "labels.* or qrels.*",
                    folder.string()));
  }
  SubmittedDataset dataset{.name = fs::weakly_canonical(folder).filename().string(), .folder = folder, .files = common};
  for (const auto& [stem, file] : {std::pair{"labels", &EvaluationFiles::labels},
                                   {"targets", &EvaluationFiles::targets},
                                   {"qrels", &EvaluationFiles::qrels},
                                   {"ids", &EvaluationFiles::ids}}) {
    if ((dataset.files.*file).empty()) dataset.files.*file = only_file(folder, stem);
  }
  if (dataset.files.labels.empty() == dataset.files.qrels.empty()) {
    throw InputError(
        fmt::format("{}: {}; a data set has one file, labels.* or qrels.*; or give `labels` or `qrels` of "
                    "all submissions",
                    folder.string(), dataset.files.labels.empty() ? "no labels" : "labels and judgements"));
  }
  return dataset;
}

// Returns the data sets of each method, by name, as indices in ascending order.
std::map<std::string, std::vector<std::size_t>> datasets_of_methods(const std::vector<Leaderboard>& boards) {
  std::map<std::string, std::vector<std::size_t>> datasets;
  for (std::size_t i = 0; i < boards.size(); ++i) {
    for (const EvaluatedSubmission& judged : boards[i].submissions) datasets[judged.submission.name].push_back(i);
  }
  return datasets;
}

const EvaluatedSubmission& submission_of(const std::string& method, const Leaderboard& board) {
  return *std::ranges::find(board.submissions, method,
                            [](const EvaluatedSubmission& one) { return one.submission.name; });
}

// Refuses methods that a data set lacks. Returns the names of the others.
std::vector<std::string> common_methods(DatasetLeaderboards& all) {
  const auto datasets = datasets_of_methods(all.boards);
  std::vector<std::string> common;
  for (const EvaluatedSubmission& judged : all.boards.front().submissions) {
    const std::string& name = judged.submission.name;
    if (datasets.at(name).size() == all.boards.size()) common.push_back(name);
  }
  for (const auto& [name, known] : datasets) {
    if (known.size() == all.boards.size()) continue;
    std::size_t missing = 0;
    while (missing < known.size() && known[missing] == missing) ++missing;
    all.refused.push_back({.file = submission_of(name, all.boards[known.front()]).submission.file,
                           .reason = fmt::format("the method {} has no valid submission for the data set {}; methods "
                                                 "are matched by their names",
                                                 quoted_word(name), all.datasets[missing].name)});
  }
  if (!common.empty()) return common;
  throw InputError(fmt::format("no method has submissions for all data sets: {}: {}", all.refused.back().file.string(),
                               all.refused.back().reason));
}

EvaluatedDataset evaluated_dataset(const SubmittedDataset& dataset, const Leaderboard& board,
                                   const std::vector<std::string>& methods) {
  EvaluatedDataset evaluated{
      .name = dataset.name, .folder = {}, .page = {}, .models = board.labels.size(), .scores = {}};
  for (const std::string& method : methods) {
    const EvaluatedSubmission& judged = submission_of(method, board);
    evaluated.scores.push_back(scores_of(judged, board.class_names));
    evaluated.micro_deviations.push_back(judged.micro_deviation);
    evaluated.macro_deviations.push_back(judged.macro_deviation);
  }
  return evaluated;
}

void compare_on_all(const JudgingOptions& options, DatasetLeaderboards& all) {
  MultiDatasetResults& results = all.results;
  results.methods = common_methods(all);
  results.main_measure = all.boards.front().measures[all.boards.front().rank_by];
  results.alpha = significance_level(options.standings.confidence);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < all.datasets.size(); ++i) {
    results.datasets.push_back(evaluated_dataset(all.datasets[i], all.boards[i], results.methods));
    names.push_back(all.datasets[i].name);
  }
  const std::vector<std::string> folders = file_safe_names(names);
  for (std::size_t i = 0; i < folders.size(); ++i) results.datasets[i].folder = folders[i];
  results.tables = multi_dataset_tables(results.datasets, results.alpha, options.standings.resampling);
}

}  // namespace

std::vector<SubmittedDataset> find_submitted_datasets(std::span<const fs::path> folders,
                                                      const EvaluationFiles& common) {
  std::vector<SubmittedDataset> datasets;
  for (const fs::path& folder : folders) {
    SubmittedDataset dataset = submitted_dataset(folder, common);
    for (const SubmittedDataset& other : datasets) {
      if (other.name == dataset.name) {
        throw InputError(fmt::format("{} and {}: two data sets have the name {}; rename a folder",
                                     other.folder.string(), folder.string(), quoted_word(dataset.name)));
      }
      if (other.files.labels.empty() != dataset.files.labels.empty()) {
        throw InputError(fmt::format("{} and {}: labels and judgements give different measures; use one kind",
                                     other.folder.string(), folder.string()));
      }
    }
    datasets.push_back(std::move(dataset));
  }
  return datasets;
}

DatasetLeaderboards evaluate_datasets(const std::vector<SubmittedDataset>& datasets, const JudgingOptions& options,
                                      Cache& cache, const JudgingProgress& progress) {
  DatasetLeaderboards all{.datasets = datasets, .boards = {}, .results = {}, .refused = {}, .skipped = {}};
  for (const SubmittedDataset& dataset : datasets) {
    JudgingOptions dataset_options = options;
    dataset_options.files = dataset.files;
    const std::vector<fs::path> about{dataset_options.files.labels, dataset_options.files.targets,
                                      dataset_options.files.qrels, dataset_options.files.ids};
    const FoundSubmissions found = find_submissions(std::span(&dataset.folder, 1), about);
    const auto within = [&](const std::string& name, std::size_t done, std::size_t count) {
      if (progress) progress(fmt::format("{}, {}", dataset.name, name), done, count);
    };
    try {
      all.boards.push_back(judge_submissions(found, dataset_options, cache, within));
    } catch (const InputError& error) {
      throw InputError(fmt::format("data set {}: {}", dataset.name, error.what()));
    }
    std::ranges::copy(all.boards.back().refused, std::back_inserter(all.refused));
    std::ranges::copy(found.skipped, std::back_inserter(all.skipped));
  }
  compare_on_all(options, all);
  return all;
}

nlohmann::ordered_json dataset_leaderboards_json(const DatasetLeaderboards& all, const JudgingOptions& options) {
  nlohmann::ordered_json json = multi_dataset_json(all.results);
  json["resamples"] = options.standings.resampling.resamples;
  json["seed"] = options.standings.resampling.seed;
  json["refused"] = nlohmann::ordered_json::array();
  for (const RefusedSubmission& refused : all.refused) {
    const fs::path folder = fs::weakly_canonical(refused.file).parent_path().filename();
    json["refused"].push_back({{"file", (folder / refused.file.filename()).string()},
                               {"reason", without_folders(refused.reason, refused.file, {})}});
  }
  return json;
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/leaderboard/write_leaderboard.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/json_text.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/leaderboard/leaderboard_tables.h"
#include "shapegauge/experiments/results/evaluation_report.h"
#include "shapegauge/pages/leaderboard_page.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view format_of_site = "shapegauge leaderboard 1";

// Returns the pages written by an earlier call, with the keys of their contents.
std::map<std::string, std::string> earlier_pages(const fs::path& folder) {
  std::map<std::string, std::string> keys;
  std::error_code unknown;
  if (!fs::exists(folder / site_data, unknown)) return keys;
  const auto json = nlohmann::json::parse(read_file_bytes(folder / site_data), nullptr, false);
  if (!json.is_object() || !json.contains("pages") || !json["pages"].is_object()) return keys;
  for (const auto& [page, key] : json["pages"].items()) {
    // Only names that this function writes: no path may lead out of the folder.
    const fs::path path(page);
    const bool is_method_page = path.parent_path() == site_methods && path.extension() == ".html";
    if (is_method_page && key.is_string()) keys.emplace(page, key.get<std::string>());
  }
  return keys;
}

// Returns the address of each submission's page; empty if it has none.
std::vector<std::string> page_names(const Leaderboard& board, bool hide_classes) {
  std::vector<std::string> names;
  for (const EvaluatedSubmission& judged : board.submissions) names.push_back(judged.submission.name);
  std::vector<std::string> pages = file_safe_names(names);
  for (std::size_t i = 0; i < pages.size(); ++i) {
    pages[i] =
        board.submissions[i].fit_for_report && !hide_classes ? fmt::format("{}/{}.html", site_methods, pages[i]) : "";
  }
  return pages;
}

// Returns a key of the contents of a submission's page.
std::string page_key(const EvaluatedSubmission& judged) { return sha256(judged.submission.name + judged.key); }

void write_submission_page(const fs::path& file, const EvaluatedSubmission& judged) {
  const EvaluationData data = open_evaluation_files(judged.files);
  const NamedEvaluation named{.method = judged.submission.name, .evaluation = &judged.evaluation};
  write_file_atomically(file, evaluation_report_page(named, data));
}

nlohmann::ordered_json site_json(const Leaderboard& board, const JudgingOptions& options,
                                 const std::map<std::string, std::string>& pages) {
  nlohmann::ordered_json json{{"format", format_of_site}};
  json.update(leaderboard_json(board, options));
  json["pages"] = pages;
  return json;
}

std::string latex_of(const Leaderboard& board) { return to_latex(leaderboard_table(board, {})); }

}  // namespace

std::string leaderboard_html(const std::string& title, const Leaderboard& board, const JudgingOptions& options,
                             const std::vector<std::string>& pages) {
  const Evaluation& first = board.submissions.front().evaluation;
  LeaderboardPage page{.title = title,
                       .facts = {{"queries", fmt::format("{}", first.queries.size())},
                                 {"protocol", name_of(first.protocol)},
                                 {"ties", name_of(first.ties)}},
                       .classes = options.hide_classes ? std::vector<std::string>() : board.class_names,
                       .labels = options.hide_classes ? std::vector<int>() : board.labels,
                       .entries = {},
                       .micro = board.micro,
                       .macro = board.macro,
                       .rank_by = board.rank_by,
                       .significance = explain_significance(board, options.standings),
                       .refused = {},
                       .csv = to_csv(leaderboard_csv_table(board)),
                       .latex = latex_of(board)};
  const auto for_readers = [&](const std::string& text, const fs::path& file) {
    return without_folders(text, file, options.files);
  };
  for (std::size_t i = 0; i < board.submissions.size(); ++i) {
    const EvaluatedSubmission& judged = board.submissions[i];
    std::vector<std::string> warnings;
    for (const std::string& warning : judged.warnings) warnings.push_back(for_readers(warning, judged.submission.file));
    page.entries.push_back({.name = judged.submission.name,
                            .authors = judged.submission.authors,
                            .paper = judged.submission.paper,
                            .url = judged.submission.url,
                            .file = judged.submission.file.filename().string(),
                            .page = i < pages.size() ? pages[i] : "",
                            .evaluation = &judged.evaluation,
                            .warnings = std::move(warnings),
                            .micro_deviation = judged.micro_deviation,
                            .macro_deviation = judged.macro_deviation});
  }
  for (const RefusedSubmission& refused : board.refused) {
    page.refused.emplace_back(refused.file.filename().string(), for_readers(refused.reason, refused.file));
  }
  return leaderboard_page(page);
}

void check_site_folder(const fs::path& folder) {
  std::error_code unknown;
  if (!fs::exists(folder, unknown)) return;
  if (!is_folder(folder)) throw InputError(fmt::format("{} is a file; a site needs a folder", folder.string()));
  const auto is_hidden = [](const fs::directory_entry& entry) {
    return entry.path().filename().string().starts_with('.');
  };
  if (std::ranges::all_of(fs::directory_iterator(folder), is_hidden)) return;  // such as those of an interrupted call
  if (fs::exists(folder / site_data, unknown)) {
    const auto json = nlohmann::json::parse(read_file_bytes(folder / site_data), nullptr, false);
    if (json.is_object() && json.value("format", nlohmann::json()) == format_of_site) return;
  }
  throw InputError(fmt::format(
      "{}: the folder has files and is not a leaderboard site; use a new folder, or a page that ends in .html",
      folder.string()));
}

SiteUpdate write_site(const fs::path& folder, const std::string& title, const Leaderboard& board,
                      const JudgingOptions& options) {
  check_site_folder(folder);
  const FolderLock lock(folder);
  const std::map<std::string, std::string> earlier = earlier_pages(folder);
  const std::vector<std::string> pages = page_names(board, options.hide_classes);
  std::map<std::string, std::string> keys;
  std::map<std::string, std::string> begun = earlier;  // a page that is being written has no key
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    if (pages[i].empty()) continue;
    const std::string& key = keys[pages[i]] = page_key(board.submissions[i]);
    std::error_code unknown;
    if (begun[pages[i]] == key && fs::exists(folder / pages[i], unknown)) continue;
    begun[pages[i]].clear();
    changed.push_back(i);
  }
  // Written first, it marks the folder as a site, which an interruption leaves to the next call.
  write_file_atomically(folder / site_data, json_text(site_json(board, options, begun), 2) + "\n");
  make_folder(folder / site_methods);
  for (const std::size_t i : changed) write_submission_page(folder / pages[i], board.submissions[i]);
  SiteUpdate update{.written = changed.size(), .unchanged = keys.size() - changed.size()};
  write_file_atomically(folder / site_index, leaderboard_html(title, board, options, pages));
  write_file_atomically(folder / site_csv, to_csv(leaderboard_csv_table(board)));
  write_file_atomically(folder / site_latex, latex_of(board));
  write_file_atomically(folder / site_data, json_text(site_json(board, options, keys), 2) + "\n");
  std::error_code absent;
  for (const auto& [page, key] : earlier) {
    if (!keys.contains(page) && fs::remove(folder / page, absent)) ++update.removed;
  }
  return update;
}

std::string dataset_leaderboards_html(const std::string& title, const DatasetLeaderboards& all) {
  MultiDatasetResults results = all.results;
  results.name = title;
  for (const RefusedSubmission& refused : all.refused) {
    results.failures.emplace_back(refused.file.filename().string(), without_folders(refused.reason, refused.file, {}));
  }
  return multi_dataset_html(results);
}

SiteUpdate write_dataset_site(const fs::path& folder, const std::string& title, const DatasetLeaderboards& all,
                              const JudgingOptions& options) {
  check_site_folder(folder);
  const FolderLock lock(folder);
  nlohmann::ordered_json json{{"format", format_of_site}};
  json.update(dataset_leaderboards_json(all, options));
  write_file_atomically(folder / site_data, json_text(json, 2) + "\n");
  DatasetLeaderboards linked = all;
  SiteUpdate sum;
  for (std::size_t i = 0; i < all.datasets.size(); ++i) {
    EvaluatedDataset& dataset = linked.results.datasets[i];
    dataset.page = fmt::format("{}/{}", dataset.folder, site_index);
    JudgingOptions dataset_options = options;
    dataset_options.files = all.datasets[i].files;
    const SiteUpdate update =
        write_site(folder / dataset.folder, fmt::format("{}: {}", title, dataset.name), all.boards[i], dataset_options);
    sum.written += update.written;
    sum.unchanged += update.unchanged;
    sum.removed += update.removed;
  }
  const MultiDatasetTable& main = main_table(all.results);
  write_file_atomically(folder / site_csv, to_csv(multi_dataset_csv_table(all.results)));
  write_file_atomically(folder / site_latex, to_latex(multi_dataset_summary(all.results, main)));
  write_file_atomically(folder / site_index, dataset_leaderboards_html(title, linked));
  return sum;
}

}  // namespace shapegauge

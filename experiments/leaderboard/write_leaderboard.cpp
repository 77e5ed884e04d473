#include "shapegauge/experiments/leaderboard/write_leaderboard.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/version.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/leaderboard/evaluation_record.h"
#include "shapegauge/experiments/leaderboard/leaderboard_tables.h"
#include "shapegauge/experiments/results/evaluation_report.h"
#include "shapegauge/pages/leaderboard_page.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view format_of_site = "shapegauge leaderboard 1";

std::string significance_words(const StandingOptions& options) {
  return fmt::format(
      "{:g} % bootstrap intervals over {}. Methods that share a letter do not differ significantly (randomised Tukey "
      "HSD over {}, p > {:.3g}).",
      100 * options.confidence, name_of(options.blocks), name_of(options.blocks), 1 - options.confidence);
}

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
    const bool own = path.parent_path() == site_methods && path.extension() == ".html";
    if (own && key.is_string()) keys.emplace(page, key.get<std::string>());
  }
  return keys;
}

// Returns the address of each submission's page; empty if it cannot have one.
std::vector<std::string> page_names(const Leaderboard& board) {
  std::vector<std::string> names;
  for (const JudgedSubmission& judged : board.submissions) names.push_back(judged.submission.name);
  std::vector<std::string> pages = file_safe_names(names);
  for (std::size_t i = 0; i < pages.size(); ++i) {
    pages[i] = board.submissions[i].fit_for_report ? fmt::format("{}/{}.html", site_methods, pages[i]) : "";
  }
  return pages;
}

// Returns a key of the contents of a submission's page.
std::string page_key(const JudgedSubmission& judged) {
  const nlohmann::json shown{{"name", judged.submission.name},
                             {"sha256", judged.sha256},
                             {"similarity", judged.files.similarity},
                             {"distance", judged.files.distance},
                             {"ids", judged.query_ids},
                             {"evaluation", to_record(judged.evaluation)},
                             {"version", version()},
                             {"commit", commit()}};
  return sha256(shown.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

void write_submission_page(const fs::path& file, const JudgedSubmission& judged) {
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
                       .classes = board.class_names,
                       .labels = board.labels,
                       .entries = {},
                       .micro = board.micro,
                       .macro = board.macro,
                       .rank_by = board.rank_by,
                       .significance = significance_words(options.standings),
                       .refused = {},
                       .csv = to_csv(leaderboard_csv_table(board)),
                       .latex = latex_of(board)};
  for (std::size_t i = 0; i < board.submissions.size(); ++i) {
    const JudgedSubmission& judged = board.submissions[i];
    page.entries.push_back({.name = judged.submission.name,
                            .authors = judged.submission.authors,
                            .paper = judged.submission.paper,
                            .url = judged.submission.url,
                            .file = judged.submission.file.filename().string(),
                            .page = i < pages.size() ? pages[i] : "",
                            .evaluation = &judged.evaluation,
                            .warnings = judged.warnings});
  }
  for (const RefusedSubmission& refused : board.refused) {
    page.refused.emplace_back(refused.file.filename().string(), refused.reason);
  }
  return leaderboard_page(page);
}

void check_site_folder(const fs::path& folder) {
  std::error_code unknown;
  if (!fs::exists(folder, unknown)) return;
  if (!is_folder(folder)) throw InputError(fmt::format("{}: is a file, not a folder for a site", folder.string()));
  if (fs::is_empty(folder, unknown)) return;
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
  const std::vector<std::string> pages = page_names(board);
  std::error_code failure;
  fs::create_directories(folder / site_methods, failure);
  if (failure) {
    throw InputError(fmt::format("cannot create {}: {}", (folder / site_methods).string(), failure.message()));
  }
  SiteUpdate update;
  std::map<std::string, std::string> keys;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    if (pages[i].empty()) continue;
    const std::string key = page_key(board.submissions[i]);
    const auto known = earlier.find(pages[i]);
    keys.emplace(pages[i], key);
    std::error_code unknown;
    if (known != earlier.end() && known->second == key && fs::exists(folder / pages[i], unknown)) {
      ++update.unchanged;
      continue;
    }
    write_submission_page(folder / pages[i], board.submissions[i]);
    ++update.written;
  }
  write_file_atomically(folder / site_index, leaderboard_html(title, board, options, pages));
  write_file_atomically(folder / site_csv, to_csv(leaderboard_csv_table(board)));
  write_file_atomically(folder / site_latex, latex_of(board));
  write_file_atomically(folder / site_data, site_json(board, options, keys).dump(2) + "\n");
  for (const auto& [page, key] : earlier) {
    if (!keys.contains(page) && fs::remove(folder / page, failure)) ++update.removed;
  }
  return update;
}

}  // namespace shapegauge

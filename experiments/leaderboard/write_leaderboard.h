#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "shapegauge/experiments/leaderboard/judge_submissions.h"

namespace shapegauge {

/// The leaderboard as one HTML file; `pages` are the relative addresses of pages of the submissions, empty where there
/// are none.
std::string leaderboard_html(const std::string& title, const Leaderboard& board, const JudgingOptions& options,
                             const std::vector<std::string>& pages = {});

/// The files of a site, by name in its folder. leaderboard.json marks the folder as a site.
inline constexpr std::string_view site_index = "index.html";
inline constexpr std::string_view site_data = "leaderboard.json";
inline constexpr std::string_view site_csv = "leaderboard.csv";
inline constexpr std::string_view site_latex = "leaderboard.tex";
inline constexpr std::string_view site_methods = "methods";  ///< folder of a page for each submission

/// Throws InputError where the folder is a file, or holds files but no site of an earlier call.
void check_site_folder(const std::filesystem::path& folder);

/// What changed in a site.
struct SiteUpdate {
  std::size_t written = 0;    ///< pages of submissions that are new or changed
  std::size_t unchanged = 0;  ///< pages that were left alone
  std::size_t removed = 0;    ///< pages of submissions that are gone
};

/// Writes a static site: the leaderboard, its table as CSV, LaTeX and JSON, and the report of each submission that can
/// have one (is_fit_for_report()). Only pages of submissions that are new or changed since the site was written are
/// written. Throws InputError as check_site_folder(), and where a file cannot be read or written.
SiteUpdate write_site(const std::filesystem::path& folder, const std::string& title, const Leaderboard& board,
                      const JudgingOptions& options);

}  // namespace shapegauge

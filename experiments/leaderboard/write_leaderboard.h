// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "shapegauge/experiments/leaderboard/dataset_leaderboards.h"
#include "shapegauge/experiments/leaderboard/judge_submissions.h"

namespace shapegauge {

/// Renders the leaderboard as one HTML file. `pages` has the relative address of each submission's page, empty for a
/// submission without a page.
std::string leaderboard_html(const std::string& title, const Leaderboard& board, const JudgingOptions& options,
                             const std::vector<std::string>& pages = {});

/// Names of the files of a leaderboard site. site_data marks a folder as a site.
inline constexpr std::string_view site_index = "index.html";       ///< HTML file of the leaderboard
inline constexpr std::string_view site_data = "leaderboard.json";  ///< JSON file of the leaderboard; it marks a site
inline constexpr std::string_view site_csv = "leaderboard.csv";    ///< CSV file of the leaderboard
inline constexpr std::string_view site_latex = "leaderboard.tex";  ///< LaTeX file of the leaderboard
inline constexpr std::string_view site_methods = "methods";        ///< folder with a page for each submission

/// Checks that a leaderboard site can be written to a folder. Throws InputError if the path is a file, or a folder with
/// files that is not an earlier site.
void check_site_folder(const std::filesystem::path& folder);

/// Numbers of pages of submissions that a call of write_site() has written, left unchanged and removed.
struct SiteUpdate {
  std::size_t written = 0;    ///< number of pages of new or changed submissions
  std::size_t unchanged = 0;  ///< number of pages of unchanged submissions
  std::size_t removed = 0;    ///< number of pages of removed submissions
};

/// Writes a static leaderboard site: the leaderboard, its table as CSV, LaTeX and JSON, and the report of each
/// submission that can have one (is_fit_for_report()) unless classes are hidden. Rewrites only the pages of new or
/// changed submissions. Throws InputError as check_site_folder() does, and if a file cannot be read or written.
SiteUpdate write_site(const std::filesystem::path& folder, const std::string& title, const Leaderboard& board,
                      const JudgingOptions& options);

/// Renders the comparison of methods over several data sets as one HTML file.
std::string dataset_leaderboards_html(const std::string& title, const DatasetLeaderboards& all);

/// Writes a static site of several data sets: the comparison as page, CSV, LaTeX and JSON, and the leaderboard site of
/// each data set in a folder. Returns the numbers of pages, summed over the data sets. Throws InputError as
/// write_site() does.
SiteUpdate write_dataset_site(const std::filesystem::path& folder, const std::string& title,
                              const DatasetLeaderboards& all, const JudgingOptions& options);

}  // namespace shapegauge

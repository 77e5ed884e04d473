// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/method_standings.h"

namespace shapegauge {

/// Method on a leaderboard.
struct LeaderboardEntry {
  std::string name;
  std::string authors;
  std::string paper;
  std::string url;   ///< begins with http:// or https://; empty for none
  std::string file;  ///< name of the submission
  std::string page;  ///< relative address of its own page; empty for none
  const Evaluation* evaluation = nullptr;
  std::vector<std::string> warnings;
  /// Standard deviations of the averages over repetitions of the method, by measure; empty without.
  /// @{
  Eigen::VectorXd micro_deviation{};
  Eigen::VectorXd macro_deviation{};
  /// @}
};

/// Contents of a leaderboard. Everything it points to must outlive it. Evaluations are of the same queries, under one
/// protocol, with the same measures.
struct LeaderboardPage {
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts;  ///< headings and texts
  std::vector<std::string> classes;                        ///< names, by label; empty if hidden
  std::vector<int> labels;                                 ///< class of each target
  std::vector<LeaderboardEntry> entries;                   ///< best first; at least one
  std::vector<std::vector<MethodStanding>> micro;          ///< averages over queries: by measure, by entry
  std::vector<std::vector<MethodStanding>> macro;          ///< averages over classes: by measure, by entry
  std::size_t rank_by = 0;                                 ///< measure shown first
  std::string significance;  ///< explanation of intervals and groups, one or more sentences
  std::vector<std::pair<std::string, std::string>> refused;  ///< omitted submissions and the reasons
  std::string csv;                                           ///< table for download
  std::string latex;                                         ///< table for download
};

/// Renders the leaderboard as one self-contained HTML file. The same leaderboard gives the same bytes.
std::string leaderboard_page(const LeaderboardPage& page);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/method_standings.h"

namespace shapegauge {

/// Entry of a leaderboard: a method with its description and evaluation.
struct LeaderboardEntry {
  std::string name;                        ///< name of the method
  std::string authors;                     ///< authors of the method; empty if unknown
  std::string paper;                       ///< reference to the publication; empty if unknown
  std::string url;                         ///< web address, with http:// or https://; empty for none
  std::string file;                        ///< name of the submitted file
  std::string page;                        ///< relative address of the method's own page; empty for none
  const Evaluation* evaluation = nullptr;  ///< scores of the method; never null
  std::vector<std::string> warnings;       ///< warnings about the submission
  // Standard deviations over repetitions of the method, one per measure; empty without repetitions.
  Eigen::VectorXd micro_deviation{};  ///< standard deviation of each average over queries; empty without repetitions
  Eigen::VectorXd macro_deviation{};  ///< standard deviation of each average over classes; empty without repetitions
};

/// Contents of a leaderboard. Everything it points to must outlive it. Evaluations are of the same queries, under one
/// protocol, with the same measures.
struct LeaderboardPage {
  std::string title;                                       ///< title of the page
  std::vector<std::pair<std::string, std::string>> facts;  ///< facts about the evaluation: pairs of heading and text
  std::vector<std::string> classes;                        ///< names of the classes; empty if they are hidden
  std::vector<int> labels;                                 ///< index in `classes` of the class of each target
  std::vector<LeaderboardEntry> entries;                   ///< methods, best first; at least one
  std::vector<std::vector<MethodStanding>> micro;          ///< standings by averages over queries: [measure][entry]
  std::vector<std::vector<MethodStanding>> macro;          ///< standings by averages over classes: [measure][entry]
  std::size_t rank_by = 0;                                 ///< index of the measure that is shown first
  std::string significance;  ///< explanation of confidence intervals and significance groups, one or more sentences
  std::vector<std::pair<std::string, std::string>> refused;  ///< names of omitted submissions and the reasons
  std::string csv;                                           ///< leaderboard as CSV, for download
  std::string latex;                                         ///< leaderboard as LaTeX, for download
};

/// Renders the leaderboard as one self-contained HTML file. The same leaderboard gives the same bytes.
std::string leaderboard_page(const LeaderboardPage& page);

}  // namespace shapegauge

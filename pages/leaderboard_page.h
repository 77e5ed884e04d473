#pragma once

#include <string>
#include <utility>
#include <vector>

#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/method_standings.h"

namespace shapegauge {

/// A method on a leaderboard.
struct LeaderboardEntry {
  std::string name;
  std::string authors;
  std::string paper;
  std::string url;   ///< begins with http:// or https://; empty: none
  std::string file;  ///< name of the submission
  std::string page;  ///< relative address of a page of its own; empty: none
  const Evaluation* evaluation = nullptr;
  std::vector<std::string> warnings;
};

/// All that a leaderboard shows. What it points to must outlive it. Evaluations are of the same queries, under one
/// protocol, with the same measures.
struct LeaderboardPage {
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts;  ///< a heading and what is to be said
  std::vector<std::string> classes;                        ///< names, by label
  std::vector<int> labels;                                 ///< class of each model to be found
  std::vector<LeaderboardEntry> entries;                   ///< the best first; at least one
  std::vector<std::vector<MethodStanding>> micro;          ///< averages over queries: by measure, by entry
  std::vector<std::vector<MethodStanding>> macro;          ///< averages over classes: so too
  std::size_t rank_by = 0;                                 ///< the measure shown first
  std::string significance;                                ///< how intervals and groups are made, one or more sentences
  std::vector<std::pair<std::string, std::string>> refused;  ///< submissions left out, and why
  std::string csv;                                           ///< the table to download
  std::string latex;                                         ///< so too
};

/// The leaderboard as one HTML file that needs nothing else. The same leaderboard gives the same bytes.
std::string leaderboard_page(const LeaderboardPage& page);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/pages/leaderboard_page.h"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "shapegauge/core/version.h"
#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/score_json.h"

namespace shapegauge {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// What charts read, and the number of queries.
OrderedJson entry_evaluation_json(const Evaluation& evaluation, bool hide_classes) {
  OrderedJson json = chart_data_json(evaluation);
  json["queries"] = evaluation.queries.size();
  if (hide_classes) json["classes"] = json["per_class"] = OrderedJson::array();
  return json;
}

OrderedJson entry_json(const LeaderboardEntry& entry, bool hide_classes) {
  return {{"name", entry.name},
          {"description", ""},
          {"authors", entry.authors},
          {"paper", entry.paper},
          {"url", entry.url},
          {"file", entry.file},
          {"page", entry.page},
          {"warnings", entry.warnings},
          {"deviations",
           {{"micro", rounded_scores(entry.micro_deviation)}, {"macro", rounded_scores(entry.macro_deviation)}}},
          {"evaluations", OrderedJson::array({entry_evaluation_json(*entry.evaluation, hide_classes)})}};
}

OrderedJson standings_json(const std::vector<std::vector<MethodStanding>>& by_measure) {
  OrderedJson measures = OrderedJson::array();
  for (const std::vector<MethodStanding>& standings : by_measure) {
    OrderedJson& methods = measures.emplace_back(OrderedJson::array());
    for (const MethodStanding& one : standings) {
      OrderedJson json{{"average", rounded_to_digits(one.average, score_digits)},
                       {"rank", one.rank},
                       {"ranks", {one.best_rank, one.worst_rank}},
                       {"letters", one.letters}};
      if (one.interval) json["interval"] = rounded_scores(Eigen::Vector2d(one.interval->low, one.interval->high));
      methods.push_back(std::move(json));
    }
  }
  return measures;
}

OrderedJson page_data_of_leaderboard(const LeaderboardPage& page) {
  OrderedJson methods = OrderedJson::array();
  for (const LeaderboardEntry& entry : page.entries) methods.push_back(entry_json(entry, page.classes.empty()));
  return {{"version", version()},
          {"title", page.title},
          {"facts", page.facts},
          {"classes", page.classes},
          {"labels", page.labels},
          {"methods", std::move(methods)},
          {"micro", standings_json(page.micro)},
          {"macro", standings_json(page.macro)},
          {"rank_by", page.rank_by},
          {"significance", page.significance},
          {"refused", page.refused},
          {"downloads", {{"csv", page.csv}, {"latex", page.latex}}}};
}

}  // namespace

std::string leaderboard_page(const LeaderboardPage& page) {
  return scripted_page({.title = page.title,
                        .kind = "leaderboard",
                        .main = page_files::leaderboard_page(),
                        .styles = {page_files::report_style(), page_files::leaderboard_style()},
                        .libraries = {page_files::chart_library()},
                        .data = page_data_of_leaderboard(page),
                        .script = page_files::leaderboard_script()});
}

}  // namespace shapegauge

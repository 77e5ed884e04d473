#include "shapegauge/pages/leaderboard_page.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "shapegauge/core/version.h"
#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/palette.h"

namespace shapegauge {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int shown_digits = 6;

template <typename Values>
OrderedJson rounded_list(const Values& values) {
  OrderedJson json = OrderedJson::array();
  for (const double value : values) json.push_back(rounded(value, shown_digits));
  return json;
}

// Returns the parts of an evaluation used by the charts of reports (report_json.h).
OrderedJson charted_json(const Evaluation& evaluation) {
  OrderedJson per_class = OrderedJson::array();
  for (Eigen::Index row = 0; row < evaluation.per_class.rows(); ++row) {
    per_class.push_back(rounded_list(evaluation.per_class.row(row)));
  }
  return {{"protocol", name_of(evaluation.protocol)},
          {"measures", evaluation.measures},
          {"queries", evaluation.queries.size()},
          {"micro", rounded_list(evaluation.micro)},
          {"macro", rounded_list(evaluation.macro)},
          {"classes", evaluation.classes},
          {"per_class", std::move(per_class)},
          {"recall", evaluation.micro_curve.recall},
          {"micro_curve", rounded_list(evaluation.micro_curve.precision)},
          {"macro_curve", rounded_list(evaluation.macro_curve.precision)}};
}

OrderedJson entry_json(const LeaderboardEntry& entry) {
  return {{"name", entry.name},
          {"description", ""},
          {"authors", entry.authors},
          {"paper", entry.paper},
          {"url", entry.url},
          {"file", entry.file},
          {"page", entry.page},
          {"warnings", entry.warnings},
          {"evaluations", OrderedJson::array({charted_json(*entry.evaluation)})}};
}

OrderedJson standings_json(const std::vector<std::vector<MethodStanding>>& by_measure) {
  OrderedJson measures = OrderedJson::array();
  for (const std::vector<MethodStanding>& standings : by_measure) {
    OrderedJson& methods = measures.emplace_back(OrderedJson::array());
    for (const MethodStanding& one : standings) {
      OrderedJson json{{"average", rounded(one.average, shown_digits)},
                       {"rank", one.rank},
                       {"ranks", {one.best_rank, one.worst_rank}},
                       {"letters", one.letters}};
      if (one.interval) json["interval"] = rounded_list(std::array{one.interval->low, one.interval->high});
      methods.push_back(std::move(json));
    }
  }
  return measures;
}

OrderedJson leaderboard_json(const LeaderboardPage& page) {
  OrderedJson methods = OrderedJson::array();
  for (const LeaderboardEntry& entry : page.entries) methods.push_back(entry_json(entry));
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
  const std::string title = html_text(page.title);
  const std::string style = palette_style()
                                .append(page_files::common_style())
                                .append(page_files::report_style())
                                .append(page_files::leaderboard_style());
  const std::string data = script_data(leaderboard_json(page));
  const std::array<std::pair<std::string_view, std::string_view>, 5> marks{
      {{"{{title}}", title},
       {"{{style}}", style},
       {"{{libraries}}", page_files::chart_library()},
       {"{{data}}", data},
       {"{{script}}", page_files::leaderboard_script()}}};
  return filled_page(page_files::leaderboard_page(), marks);
}

}  // namespace shapegauge

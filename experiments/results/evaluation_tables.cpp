#include "shapegauge/experiments/results/evaluation_tables.h"

#include <algorithm>
#include <fmt/format.h>

namespace shapegauge {

namespace {

using Row = std::vector<std::string>;
constexpr int csv_decimals = 4;  // percent: a hundredth of what a query of 10,000 is worth

Table table_with_measures(std::span<const NamedEvaluation> evaluations, Row words) {
  Table table{.header = std::move(words), .rows = {}, .text_columns = 0};
  table.text_columns = table.header.size();
  if (evaluations.empty()) return table;
  const std::vector<std::string>& measures = evaluations.front().evaluation->measures;
  table.header.insert(table.header.end(), measures.begin(), measures.end());
  return table;
}

void append_percent(Row& row, const Eigen::VectorXd& fractions, int decimals) {
  for (const double fraction : fractions) row.push_back(fmt::format("{:.{}f}", 100 * fraction, decimals));
}

}  // namespace

Table summary_table(std::span<const NamedEvaluation> evaluations, int decimals) {
  Table table = table_with_measures(evaluations, {"method", "protocol", "average"});
  for (const auto& [method, evaluation] : evaluations) {
    for (const bool micro : {true, false}) {
      Row row{method, name_of(evaluation->protocol), micro ? "micro" : "macro"};
      append_percent(row, micro ? evaluation->micro : evaluation->macro, decimals);
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table per_class_table(std::span<const NamedEvaluation> evaluations, std::span<const int> labels,
                      std::span<const std::string> class_names) {
  Table table = table_with_measures(evaluations, {"method", "protocol", "class", "queries"});
  for (const auto& [method, evaluation] : evaluations) {
    for (std::size_t i = 0; i < evaluation->classes.size(); ++i) {
      const int label = evaluation->classes[i];
      Row row{method, name_of(evaluation->protocol), class_names[static_cast<std::size_t>(label)],
              fmt::format("{}", std::ranges::count(labels, label))};
      append_percent(row, evaluation->per_class.row(static_cast<Eigen::Index>(i)), csv_decimals);
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table per_query_table(std::span<const NamedEvaluation> evaluations, std::span<const std::string> ids,
                      std::span<const int> labels, std::span<const std::string> class_names) {
  Table table = table_with_measures(evaluations, {"method", "protocol", "id", "class"});
  for (const auto& [method, evaluation] : evaluations) {
    for (std::size_t i = 0; i < evaluation->queries.size(); ++i) {
      const auto query = static_cast<std::size_t>(evaluation->queries[i]);
      Row row{method, name_of(evaluation->protocol), ids[query], class_names[static_cast<std::size_t>(labels[query])]};
      append_percent(row, evaluation->per_query.row(static_cast<Eigen::Index>(i)), csv_decimals);
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table precision_recall_table(std::span<const NamedEvaluation> evaluations) {
  Table table{
      .header = {"method", "protocol", "recall", "precision", "macro_precision"}, .rows = {}, .text_columns = 2};
  for (const auto& [method, evaluation] : evaluations) {
    const PrecisionRecallCurve& micro = evaluation->micro_curve;
    for (std::size_t i = 0; i < micro.recall.size(); ++i) {
      table.rows.push_back({method, name_of(evaluation->protocol), fmt::format("{}", micro.recall[i]),
                            fmt::format("{:.6f}", micro.precision[i]),
                            fmt::format("{:.6f}", evaluation->macro_curve.precision[i])});
    }
  }
  return table;
}

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/results/evaluation_tables.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace shapegauge {

namespace {

using Row = std::vector<std::string>;

TextTable table_with_measures(std::span<const NamedEvaluation> evaluations, Row words) {
  TextTable table{.header = std::move(words), .rows = {}, .text_columns = 0};
  table.text_columns = table.header.size();
  if (evaluations.empty()) return table;
  const std::vector<std::string>& measures = evaluations.front().evaluation->measures;
  table.header.insert(table.header.end(), measures.begin(), measures.end());
  return table;
}

void append_scores(Row& row, const Eigen::VectorXd& fractions, const ScoreStyle& style) {
  for (const double fraction : fractions) row.push_back(score_text(fraction, style));
}

void append_to_cells(Row& row, std::size_t first, std::span<const ConfidenceInterval> intervals,
                     const ScoreStyle& style) {
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    row[first + i] +=
        fmt::format(" [{}, {}]", score_text(intervals[i].low, style), score_text(intervals[i].high, style));
  }
}

void add_columns(Row& row, std::span<const ConfidenceInterval> intervals, const ScoreStyle& style) {
  for (const ConfidenceInterval& interval : intervals) {
    row.push_back(score_text(interval.low, style));
    row.push_back(score_text(interval.high, style));
  }
}

/// Appends the names of the columns of intervals.
void add_columns(Row& header, std::span<const std::string> measures) {
  for (const std::string& measure : measures) {
    header.push_back(measure + "_low");
    header.push_back(measure + "_high");
  }
}

/// Formats a fraction in percent exactly: moves the decimal point of its shortest text, since a multiplication by 100
/// would round.
std::string exact_percent(double fraction) {
  std::array<char, 400> buffer = {};  // the longest text of a double
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), fraction, std::chars_format::fixed);
  std::string text(buffer.data(), end);
  std::size_t point = text.find('.');
  if (point == std::string::npos) {
    point = text.size();
    text += '.';
  }
  text.append(2, '0');
  text.erase(point, 1).insert(point + 2, 1, '.');
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  text.erase(0, std::min(text.find_first_not_of('0'), text.size()));
  return text.empty() || text.starts_with('.') ? "0" + text : text;
}

bool all_have_intervals(std::span<const NamedEvaluation> evaluations) {
  return std::ranges::none_of(evaluations, [](const NamedEvaluation& named) { return named.intervals.micro.empty(); });
}

/// Returns the words and scores of an average in a row of summary_table(). With `show_failed`, the number of models
/// that failed follows the method.
Row row_of_average(const NamedEvaluation& named, bool micro, bool show_failed, const ScoreStyle& style) {
  Row row{named.method};
  if (show_failed) row.push_back(std::to_string(named.failed));
  row.insert(row.end(), {name_of(named.evaluation->protocol), micro ? "micro" : "macro"});
  append_scores(row, micro ? named.evaluation->micro : named.evaluation->macro, style);
  return row;
}

}  // namespace

std::string score_text(double fraction, const ScoreStyle& style) {
  if (style.decimals == all_decimals) return style.percent ? exact_percent(fraction) : fmt::format("{}", fraction);
  return decimal_text(style.percent ? 100 * fraction : fraction, style.decimals);
}

EvaluationIntervals intervals_of(const Evaluation& evaluation, const IntervalOptions& options) {
  const std::size_t units =
      options.blocks == ResamplingUnit::classes ? evaluation.classes.size() : evaluation.queries.size();
  if (units < 2) return {};
  const auto of = [&](Average average) {
    return bootstrap_intervals(unit_values_of(evaluation.per_query, evaluation.query_classes, options.blocks, average),
                               options.confidence, options.resampling);
  };
  return {.confidence = options.confidence, .micro = of(Average::micro), .macro = of(Average::macro)};
}

TextTable summary_table(std::span<const NamedEvaluation> evaluations, const ScoreStyle& style,
                        IntervalCells intervals) {
  const bool any_failed = std::ranges::any_of(evaluations, [](const NamedEvaluation& one) { return one.failed > 0; });
  Row words{"method"};
  if (any_failed) words.emplace_back("failed");
  words.insert(words.end(), {"protocol", "average"});
  TextTable table = table_with_measures(evaluations, std::move(words));
  const std::size_t text_columns = table.text_columns;
  const bool columns = intervals == IntervalCells::columns && all_have_intervals(evaluations);
  if (columns && !evaluations.empty()) add_columns(table.header, evaluations.front().evaluation->measures);
  for (const NamedEvaluation& named : evaluations) {
    for (const bool micro : {true, false}) {
      Row row = row_of_average(named, micro, any_failed, style);
      const std::vector<ConfidenceInterval>& of_average = micro ? named.intervals.micro : named.intervals.macro;
      if (columns) add_columns(row, of_average, style);
      if (intervals == IntervalCells::in_cells) append_to_cells(row, text_columns, of_average, style);
      table.rows.push_back(std::move(row));
    }
  }
  embolden_best(table, any_failed ? 2 : 1);
  return table;
}

TextTable merge_equal_averages(TextTable table) {
  const auto average = static_cast<std::size_t>(std::ranges::find(table.header, "average") - table.header.begin());
  for (std::size_t i = table.rows.size(); i-- > 1;) {
    Row& row = table.rows[i - 1];
    Row other = table.rows[i];
    other[average] = row[average];
    if (other != row) continue;
    row[average] = "both";
    table.rows.erase(table.rows.begin() + static_cast<std::ptrdiff_t>(i));
    std::erase_if(table.emphases, [i](const Emphasis& emphasis) { return emphasis.row == i; });
    for (Emphasis& emphasis : table.emphases) emphasis.row -= emphasis.row > i ? 1 : 0;
  }
  return table;
}

TextTable intervals_table(std::span<const NamedEvaluation> evaluations) {
  TextTable table{
      .header = {"method", "protocol", "average", "measure", "value", "low", "high"}, .rows = {}, .text_columns = 4};
  for (const NamedEvaluation& named : evaluations) {
    const Evaluation& evaluation = *named.evaluation;
    for (const bool micro : {true, false}) {
      const std::vector<ConfidenceInterval>& intervals = micro ? named.intervals.micro : named.intervals.macro;
      for (std::size_t i = 0; i < intervals.size(); ++i) {
        const double value = (micro ? evaluation.micro : evaluation.macro)[static_cast<Eigen::Index>(i)];
        table.rows.push_back({named.method, name_of(evaluation.protocol), micro ? "micro" : "macro",
                              evaluation.measures[i], score_text(value, csv_style),
                              score_text(intervals[i].low, csv_style), score_text(intervals[i].high, csv_style)});
      }
    }
  }
  return table;
}

TextTable per_class_table(std::span<const NamedEvaluation> evaluations, std::span<const std::string> class_names) {
  TextTable table = table_with_measures(evaluations, {"method", "protocol", "class", "queries"});
  for (const NamedEvaluation& named : evaluations) {
    const Evaluation& evaluation = *named.evaluation;
    for (std::size_t i = 0; i < evaluation.classes.size(); ++i) {
      const int label = evaluation.classes[i];
      Row row{named.method, name_of(evaluation.protocol), class_names[static_cast<std::size_t>(label)],
              fmt::format("{}", std::ranges::count(evaluation.query_classes, label))};
      append_scores(row, evaluation.per_class.row(static_cast<Eigen::Index>(i)), csv_style);
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

TextTable per_query_table(std::span<const NamedEvaluation> evaluations, std::span<const std::string> ids,
                          std::span<const std::string> class_names, const ScoreStyle& style) {
  TextTable table = table_with_measures(evaluations, {"method", "protocol", "id", "class"});
  for (const NamedEvaluation& named : evaluations) {
    const Evaluation& evaluation = *named.evaluation;
    for (std::size_t i = 0; i < evaluation.queries.size(); ++i) {
      Row row{named.method, name_of(evaluation.protocol), ids[static_cast<std::size_t>(evaluation.queries[i])],
              class_names[static_cast<std::size_t>(evaluation.query_classes[i])]};
      append_scores(row, evaluation.per_query.row(static_cast<Eigen::Index>(i)), style);
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

TextTable class_curves_table(std::span<const NamedEvaluation> evaluations, std::span<const std::string> class_names) {
  TextTable table{.header = {"method", "protocol", "class", "recall", "precision"}, .rows = {}, .text_columns = 3};
  for (const NamedEvaluation& named : evaluations) {
    const Evaluation& evaluation = *named.evaluation;
    for (std::size_t i = 0; i < evaluation.classes.size(); ++i) {
      const PrecisionRecallCurve& curve = evaluation.class_curves[i];
      const std::string& class_name = class_names[static_cast<std::size_t>(evaluation.classes[i])];
      for (std::size_t level = 0; level < curve.recall.size(); ++level) {
        table.rows.push_back({named.method, name_of(evaluation.protocol), class_name,
                              fmt::format("{}", curve.recall[level]), fmt::format("{:.6f}", curve.precision[level])});
      }
    }
  }
  return table;
}

std::string psb_plot(const PrecisionRecallCurve& curve) {
  std::string text;
  for (std::size_t level = 0; level < curve.recall.size(); ++level) {
    text += fmt::format("{:.6f}\t{:.6f}\n", curve.recall[level], curve.precision[level]);
  }
  return text;
}

TextTable precision_recall_table(std::span<const NamedEvaluation> evaluations) {
  TextTable table{
      .header = {"method", "protocol", "recall", "precision", "macro_precision"}, .rows = {}, .text_columns = 2};
  for (const auto& [method, evaluation, intervals, failed] : evaluations) {
    const PrecisionRecallCurve& micro = evaluation->micro_curve;
    for (std::size_t i = 0; i < micro.recall.size(); ++i) {
      table.rows.push_back({method, name_of(evaluation->protocol), fmt::format("{}", micro.recall[i]),
                            fmt::format("{:.6f}", micro.precision[i]),
                            fmt::format("{:.6f}", evaluation->macro_curve.precision[i])});
    }
  }
  return table;
}

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson measures_json(const Evaluation& evaluation, const Eigen::VectorXd& values) {
  OrderedJson json = OrderedJson::object();
  for (std::size_t i = 0; i < evaluation.measures.size(); ++i) {
    json[evaluation.measures[i]] = values[static_cast<Eigen::Index>(i)];
  }
  return json;
}

OrderedJson intervals_json(const Evaluation& evaluation, const std::vector<ConfidenceInterval>& intervals) {
  OrderedJson json = OrderedJson::object();
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    json[evaluation.measures[i]] = {intervals[i].low, intervals[i].high};
  }
  return json;
}

}  // namespace

OrderedJson per_query_json(const Evaluation& evaluation, std::span<const std::string> ids) {
  OrderedJson json = OrderedJson::object();
  for (std::size_t i = 0; i < evaluation.queries.size(); ++i) {
    json[ids[static_cast<std::size_t>(evaluation.queries[i])]] =
        measures_json(evaluation, evaluation.per_query.row(static_cast<Eigen::Index>(i)));
  }
  return json;
}

OrderedJson evaluation_json(const Evaluation& evaluation, std::span<const std::string> class_names,
                            const EvaluationIntervals& intervals) {
  OrderedJson per_class = OrderedJson::object();
  for (std::size_t i = 0; i < evaluation.classes.size(); ++i) {
    const std::string& name = class_names[static_cast<std::size_t>(evaluation.classes[i])];
    per_class[name] = measures_json(evaluation, evaluation.per_class.row(static_cast<Eigen::Index>(i)));
  }
  OrderedJson json{{"protocol", name_of(evaluation.protocol)},
                   {"ties", name_of(evaluation.ties)},
                   {"queries", evaluation.queries.size()},
                   {"queries_with_ties", evaluation.queries_with_ties},
                   {"models_never_queries", evaluation.excluded_models},
                   {"micro", measures_json(evaluation, evaluation.micro)},
                   {"macro", measures_json(evaluation, evaluation.macro)}};
  if (!intervals.micro.empty()) {
    json["intervals"] = {{"micro", intervals_json(evaluation, intervals.micro)},
                         {"macro", intervals_json(evaluation, intervals.macro)}};
  }
  json["per_class"] = std::move(per_class);
  return json;
}

}  // namespace shapegauge

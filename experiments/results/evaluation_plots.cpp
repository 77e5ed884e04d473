// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/results/evaluation_plots.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <optional>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/csv.h"
#include "shapegauge/pages/plots/charts.h"

namespace shapegauge {

namespace {

double cell_number(const std::filesystem::path& path, const CsvRow& row, std::size_t column) {
  const std::optional<double> number = parse_number(row.cells[column]);
  if (number) return *number;
  throw InputError(fmt::format("{}:{}: {} is not a number", path.string(), row.line, quoted_word(row.cells[column])));
}

}  // namespace

NamedCurve named_curve(const NamedEvaluation& named, Average average) {
  const Evaluation& evaluation = *named.evaluation;
  return {.method = named.method,
          .protocol = name_of(evaluation.protocol),
          .curve = average == Average::micro ? evaluation.micro_curve : evaluation.macro_curve};
}

std::vector<NamedCurve> read_curves(const std::filesystem::path& path, Average average) {
  const std::vector<CsvRow> rows = parse_csv(read_file_bytes(path), path.string());
  const std::vector<std::string> header{"method", "protocol", "recall", "precision", "macro_precision"};
  if (rows.empty() || rows.front().cells != header) {
    throw InputError(
        fmt::format("{}: not a table of curves: its columns must be {}", path.string(), fmt::join(header, ",")));
  }
  std::vector<NamedCurve> curves;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::vector<std::string>& cells = rows[i].cells;
    if (cells.size() != header.size()) {
      throw InputError(
          fmt::format("{}:{}: {} cells, expected {}", path.string(), rows[i].line, cells.size(), header.size()));
    }
    const bool same = !curves.empty() && curves.back().method == cells[0] && curves.back().protocol == cells[1];
    if (!same) curves.push_back({.method = cells[0], .protocol = cells[1], .curve = {}});
    curves.back().curve.recall.push_back(cell_number(path, rows[i], 2));
    curves.back().curve.precision.push_back(cell_number(path, rows[i], average == Average::micro ? 3 : 4));
  }
  return curves;
}

Drawing curves_plot(std::span<const NamedCurve> curves) {
  const bool one_protocol =
      std::ranges::all_of(curves, [&](const NamedCurve& curve) { return curve.protocol == curves.front().protocol; });
  CurveChart chart{.x = {.label = "Recall"}, .y = {.label = "Precision"}, .curves = {}};
  for (const NamedCurve& curve : curves) {
    chart.curves.push_back({.name = one_protocol ? curve.method : fmt::format("{} ({})", curve.method, curve.protocol),
                            .x = curve.curve.recall,
                            .y = curve.curve.precision});
  }
  return draw_chart(chart);
}

Drawing class_plot(std::span<const NamedEvaluation> evaluations, std::span<const std::string> class_names,
                   const std::string& measure) {
  const Evaluation& first = *evaluations.front().evaluation;
  const auto found = std::ranges::find(first.measures, measure);
  if (found == first.measures.end()) {
    throw InputError(fmt::format("the measure {} was not computed; available are {}", quoted_word(measure),
                                 fmt::join(first.measures, ", ")));
  }
  const auto column = found - first.measures.begin();
  BarChart chart{.x = {.label = measure + " (%)", .low = 0, .high = 100}, .groups = {}, .bars = {}};
  for (const int label : first.classes) chart.groups.push_back(class_names[static_cast<std::size_t>(label)]);
  for (const NamedEvaluation& named : evaluations) {
    ChartBars bars{.name = named.method, .values = {}};
    for (const int label : first.classes) {
      const auto entry = std::ranges::find(named.evaluation->classes, label);
      const bool known = entry != named.evaluation->classes.end();
      const double none = std::numeric_limits<double>::quiet_NaN();
      bars.values.push_back(known ? 100 * named.evaluation->per_class(entry - named.evaluation->classes.begin(), column)
                                  : none);
    }
    chart.bars.push_back(std::move(bars));
  }
  return draw_chart(chart);
}

Drawing scores_plot(std::span<const std::string> methods, std::span<const std::string> measures,
                    std::span<const MethodComparison> comparisons, double confidence) {
  BarChart chart;
  chart.x = {.label = fmt::format("% (with {:g} % intervals)", 100 * confidence), .low = 0, .high = 100};
  chart.groups.assign(measures.begin(), measures.end());
  for (std::size_t method = 0; method < methods.size(); ++method) {
    ChartBars bars{.name = methods[method], .values = {}};
    for (const MethodComparison& comparison : comparisons) {
      bars.values.push_back(100 * comparison.averages[static_cast<Eigen::Index>(method)]);
      if (comparison.intervals.empty()) continue;
      const ConfidenceInterval& interval = comparison.intervals[method];
      bars.intervals.emplace_back(ConfidenceInterval{100 * interval.low, 100 * interval.high});
    }
    chart.bars.push_back(std::move(bars));
  }
  return draw_chart(chart);
}

}  // namespace shapegauge

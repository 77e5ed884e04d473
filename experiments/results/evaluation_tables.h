// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// Number format of scores in tables.
struct ScoreStyle {
  bool percent = true;  ///< true for scores in percent, false for fractions
  int decimals = 2;     ///< number of decimal places, or all_decimals
};

/// Value of ScoreStyle::decimals for the smallest number of decimals that restores the score exactly.
inline constexpr int all_decimals = -1;

/// Formats a score, which is a fraction from 0 to 1, as text in the style.
std::string score_text(double fraction, const ScoreStyle& style);

/// Style of tables in CSV files: percent with four decimals.
inline constexpr ScoreStyle csv_style{.percent = true, .decimals = 4};

/// Style of tables that programs read back: percent with all decimals.
inline constexpr ScoreStyle exact_style{.percent = true, .decimals = all_decimals};

/// Options of confidence intervals (bootstrap_intervals()).
struct IntervalOptions {
  double confidence = 0.95;                         ///< confidence level of the intervals
  ResamplingUnit blocks = ResamplingUnit::classes;  ///< units to resample: whole classes or single queries
  ResamplingOptions resampling{};                   ///< number of resamples and seed
};

/// Computes the bootstrap confidence intervals of the averages of an evaluation; empty for fewer than two classes, or
/// queries, to resample.
EvaluationIntervals intervals_of(const Evaluation& evaluation, const IntervalOptions& options = {});

/// Evaluation with the name of its method.
struct NamedEvaluation {
  std::string method;                      ///< name of the method
  const Evaluation* evaluation = nullptr;  ///< scores of the method; not owned, not null
  EvaluationIntervals intervals{};         ///< confidence intervals of the averages; empty if not computed
  std::size_t failed = 0;  ///< number of models that the method cannot process, which count as not found
};

/// Placement of confidence intervals in a table. `none`: no intervals; `in_cells`: in the cell of each score;
/// `columns`: in additional columns NN_low, NN_high, ... after all scores, if every evaluation has intervals.
enum class IntervalCells { none, in_cells, columns };

/// Makes a table with a row for each evaluation and average (micro, macro): method, protocol, average, and the measures
/// of the first evaluation. If a method failed on some models, a column with their number (failed) follows the name.
/// The best score of each protocol and average is bold.
TextTable summary_table(std::span<const NamedEvaluation> evaluations, const ScoreStyle& style = {},
                        IntervalCells intervals = IntervalCells::none);

/// Merges the micro and macro rows of a method into one row with the average "both" if their formatted scores are
/// equal.
TextTable merge_equal_averages(TextTable table);

/// Makes a table with a row for each evaluation, average and measure: method, protocol, average, measure, value, low,
/// high; percent. Evaluations without intervals have no rows.
TextTable intervals_table(std::span<const NamedEvaluation> evaluations);

/// Makes a table with a row for each evaluation and class: method, protocol, class, number of queries, measures in
/// percent.
TextTable per_class_table(std::span<const NamedEvaluation> evaluations, std::span<const std::string> class_names);

/// Makes a table with a row for each evaluation and query: method, protocol, id of the query, its class, measures.
/// `ids` has the model id of each matrix row. read_method_scores() restores the scores to the bit.
TextTable per_query_table(std::span<const NamedEvaluation> evaluations, std::span<const std::string> ids,
                          std::span<const std::string> class_names, const ScoreStyle& style = exact_style);

/// Makes a table with a row for each evaluation and recall level: method, protocol, recall, precision averaged over
/// queries, precision averaged over classes; fractions.
TextTable precision_recall_table(std::span<const NamedEvaluation> evaluations);

/// Makes a table with a row for each evaluation, class and recall level: method, protocol, class, recall, precision;
/// fractions.
TextTable class_curves_table(std::span<const NamedEvaluation> evaluations, std::span<const std::string> class_names);

/// Formats a precision-recall curve like psbPlot, for gnuplot: one line per level, with recall and precision.
std::string psb_plot(const PrecisionRecallCurve& curve);

/// Returns a JSON object with the measures of each query, as fractions; its keys are the query ids. `ids` has the model
/// id of each matrix row.
nlohmann::ordered_json per_query_json(const Evaluation& evaluation, std::span<const std::string> ids);

/// Formats an evaluation as JSON (docs/reference/file_formats.md#results-of-a-run): protocol, ties, and the numbers of
/// queries, of queries affected by ties, and of models that are never queries; the measures as fractions: micro, macro,
/// and per class by the class's name; and confidence intervals of the averages, if any.
nlohmann::ordered_json evaluation_json(const Evaluation& evaluation, std::span<const std::string> class_names,
                                       const EvaluationIntervals& intervals = {});

}  // namespace shapegauge

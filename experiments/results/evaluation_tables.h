#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/metrics/bootstrap.h"
#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// How scores are written.
struct ScoreStyle {
  bool percent = true;  ///< else fractions
  int decimals = 2;     ///< all_decimals: as many as the score needs to be read back to the bit
};

inline constexpr int all_decimals = -1;

/// The score in that style.
std::string score_text(double fraction, const ScoreStyle& style);

/// Of tables in files: percent, to a hundredth of what a query of 10,000 is worth.
inline constexpr ScoreStyle csv_style{.percent = true, .decimals = 4};

/// Of tables that are read back.
inline constexpr ScoreStyle exact_style{.percent = true, .decimals = all_decimals};

/// How confidence intervals are made (bootstrap_intervals).
struct IntervalOptions {
  double confidence = 0.95;
  Blocks blocks = Blocks::classes;
  ResamplingOptions resampling{};
};

/// Intervals of an evaluation's averages, by measure. Empty where there are none.
struct EvaluationIntervals {
  std::vector<ConfidenceInterval> micro;
  std::vector<ConfidenceInterval> macro;
};

/// The intervals; none where there are fewer than two classes, or queries, to draw from.
EvaluationIntervals intervals_of(const Evaluation& evaluation, const IntervalOptions& options = {});

/// An evaluation and the name of the method that it is of.
struct NamedEvaluation {
  std::string method;
  const Evaluation* evaluation = nullptr;
  EvaluationIntervals intervals{};
};

/// Where a table has the confidence intervals: nowhere, in the cell of each score, or as further columns NN_low,
/// NN_high, ... behind all scores, where every evaluation has intervals.
enum class IntervalCells { none, beside, columns };

/// A row for each evaluation and average (micro, macro): method, protocol, average, then the measures. The measures are
/// those of the first evaluation. The best of each protocol and average is bold.
Table summary_table(std::span<const NamedEvaluation> evaluations, const ScoreStyle& style = {},
                    IntervalCells intervals = IntervalCells::none);

/// A row for each evaluation, average and measure: method, protocol, average, measure, value, low, high; percent. No
/// rows for evaluations without intervals.
Table intervals_table(std::span<const NamedEvaluation> evaluations);

/// A row for each evaluation and class: method, protocol, class, number of queries, measures in percent.
Table per_class_table(std::span<const NamedEvaluation> evaluations, std::span<const std::string> class_names);

/// A row for each evaluation and query: method, protocol, id of the query, its class, measures. ids are by row of the
/// matrix. read_method_scores() reads the scores back to the bit.
Table per_query_table(std::span<const NamedEvaluation> evaluations, std::span<const std::string> ids,
                      std::span<const std::string> class_names, const ScoreStyle& style = exact_style);

/// A row for each evaluation and level of recall: method, protocol, recall, precision averaged over queries, precision
/// averaged over classes; fractions.
Table precision_recall_table(std::span<const NamedEvaluation> evaluations);

/// A row for each evaluation, class and level of recall: method, protocol, class, recall, precision; fractions.
Table class_curves_table(std::span<const NamedEvaluation> evaluations, std::span<const std::string> class_names);

/// A curve as psbPlot writes it, for gnuplot: recall and precision, a level a line.
std::string psb_plot(const PrecisionRecallCurve& curve);

/// The measures of each query by its id, as fractions.
nlohmann::ordered_json per_query_json(const Evaluation& evaluation, std::span<const std::string> ids);

/// An evaluation as JSON (docs/reference/definitions.md#result-files): protocol, ties, number of queries, of those that
/// ties could change, and of models that are never queries; the measures as fractions: micro, macro, and per class by
/// the class's name; and where there are intervals those of the averages.
nlohmann::ordered_json evaluation_json(const Evaluation& evaluation, std::span<const std::string> class_names,
                                       const EvaluationIntervals& intervals = {});

}  // namespace shapegauge

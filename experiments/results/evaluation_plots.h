// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/metrics/method_comparison.h"
#include "shapegauge/pages/plots/drawing.h"

namespace shapegauge {

/// Precision-recall curve of a method.
struct NamedCurve {
  std::string method;          ///< name of the method
  std::string protocol;        ///< name of the evaluation protocol
  PrecisionRecallCurve curve;  ///< precision at each recall level
};

/// Returns the precision-recall curve of an evaluation, averaged over queries or classes.
NamedCurve named_curve(const NamedEvaluation& named, Average average = Average::micro);

/// Name of the file in the results of a run that has the precision-recall curves.
inline constexpr std::string_view curves_name = "pr_curves.csv";

/// Reads precision-recall curves from a table made by precision_recall_table(), such as curves_name of a run. Throws
/// InputError for a file without such a table.
std::vector<NamedCurve> read_curves(const std::filesystem::path& path, Average average = Average::micro);

/// Draws a chart of precision-recall curves. The legend names protocols if there are several.
Drawing curves_plot(std::span<const NamedCurve> curves);

/// Draws a chart of one measure in percent, with a bar for each class and method. The classes are those of the first
/// evaluation; a method without queries of a class has no bar there. Throws InputError for a measure that was not
/// computed.
Drawing class_plot(std::span<const NamedEvaluation> evaluations, std::span<const std::string> class_names,
                   const std::string& measure);

/// Draws a chart of average scores in percent, with a bar and a confidence interval for each measure and method.
/// `comparisons` has one MethodComparison per measure. `confidence` is the level of the intervals, such as 0.95.
Drawing scores_plot(std::span<const std::string> methods, std::span<const std::string> measures,
                    std::span<const MethodComparison> comparisons, double confidence);

}  // namespace shapegauge

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/metrics/method_comparison.h"
#include "shapegauge/pages/plots/drawing.h"

namespace shapegauge {

/// A precision-recall curve and the method that it is of.
struct NamedCurve {
  std::string method;
  std::string protocol;
  PrecisionRecallCurve curve;
};

/// The curve of an evaluation, averaged over queries or over classes.
NamedCurve named_curve(const NamedEvaluation& named, Average average = Average::micro);

/// The curves of a table as precision_recall_table() makes it: precision_recall.csv of a run. Throws InputError where
/// the file is no such table.
std::vector<NamedCurve> read_curves(const std::filesystem::path& path, Average average = Average::micro);

/// A chart of the curves. A method's protocol is said where there are several.
Drawing curves_plot(std::span<const NamedCurve> curves);

/// A chart with a bar for each class and method: a measure, in percent. The classes are those of the first evaluation;
/// a method without queries of a class has no bar there. Throws InputError for a measure that was not computed.
Drawing class_plot(std::span<const NamedEvaluation> evaluations, std::span<const std::string> class_names,
                   const std::string& measure);

/// A chart with a bar for each measure and method, in percent, with the intervals of the averages.
Drawing scores_plot(std::span<const std::string> methods, std::span<const std::string> measures,
                    std::span<const MethodComparison> comparisons, double confidence);

}  // namespace shapegauge

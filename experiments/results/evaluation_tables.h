#pragma once

#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/text/table.h"
#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// An evaluation and the name of the method that it is of.
struct NamedEvaluation {
  std::string method;
  const Evaluation* evaluation = nullptr;
};

/// A row for each evaluation and average (micro, macro): method, protocol, average, then the measures in percent with
/// so many decimals. The measures are those of the first evaluation.
Table summary_table(std::span<const NamedEvaluation> evaluations, int decimals);

/// A row for each evaluation and class: method, protocol, class, number of queries, measures in percent.
Table per_class_table(std::span<const NamedEvaluation> evaluations, std::span<const int> labels,
                      std::span<const std::string> class_names);

/// A row for each evaluation and query: method, protocol, id of the query, its class, measures in percent.
Table per_query_table(std::span<const NamedEvaluation> evaluations, std::span<const std::string> ids,
                      std::span<const int> labels, std::span<const std::string> class_names);

/// A row for each evaluation and level of recall: method, protocol, recall, precision averaged over queries, precision
/// averaged over classes; fractions.
Table precision_recall_table(std::span<const NamedEvaluation> evaluations);

}  // namespace shapegauge

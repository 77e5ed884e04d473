#pragma once

#include <string>
#include <vector>

#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/experiments/results/evaluation_tables.h"

namespace shapegauge {

/// An evaluation of a report and the matrix that it is of.
struct ReportedEvaluation {
  NamedEvaluation named;
  const EvaluationData* data = nullptr;
};

/// The report of several methods, whose matrices are of the same models in the same order. Throws InputError where they
/// are not.
std::string evaluation_report_page(const std::vector<ReportedEvaluation>& methods);

/// The report (pages/report.h) of a matrix that was evaluated; its task must be is_fit_for_report().
std::string evaluation_report_page(const NamedEvaluation& named, const EvaluationData& data);

}  // namespace shapegauge

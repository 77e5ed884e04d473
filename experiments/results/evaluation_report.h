#pragma once

#include <string>

#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/experiments/results/evaluation_tables.h"

namespace shapegauge {

/// The report (pages/report.h) of a matrix that was evaluated; its task must be is_fit_for_report().
std::string evaluation_report_page(const NamedEvaluation& named, const EvaluationData& data);

}  // namespace shapegauge

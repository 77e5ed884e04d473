// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/pages/report.h"

namespace shapegauge {

/// Evaluation of one method for a report, with the evaluated matrix.
struct ReportedEvaluation {
  NamedEvaluation named;                 ///< scores with the name of the method
  const EvaluationData* data = nullptr;  ///< evaluated matrix with its task; not null
};

/// Renders the report (pages/report.h) of several methods, with tests of their differences. Throws InputError unless
/// their matrices have the same models in the same order.
std::string evaluation_report_page(const std::vector<ReportedEvaluation>& methods, ReportTests tests = {});

/// Renders the report (pages/report.h) of one evaluated matrix, whose task must be is_fit_for_report().
std::string evaluation_report_page(const NamedEvaluation& named, const EvaluationData& data);

}  // namespace shapegauge

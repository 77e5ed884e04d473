// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/experiments/retrieval/experiment_results.h"
#include "shapegauge/pages/report.h"

namespace shapegauge {

/// Makes the report of a retrieval experiment. `evaluations` are those of the results, by method and then by protocol,
/// with or without confidence intervals. The report refers to `results` and `evaluations`, which must outlive it.
Report experiment_report(const ExperimentResults& results, std::span<const NamedEvaluation> evaluations);

}  // namespace shapegauge

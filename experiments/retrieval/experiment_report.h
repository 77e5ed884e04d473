// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/experiments/retrieval/experiment_results.h"
#include "shapegauge/pages/report.h"

namespace shapegauge {

/// Makes the report of a run from its results and their evaluations, by method and then by protocol, with or without
/// intervals. It refers to the results.
Report experiment_report(const ExperimentResults& results, std::span<const NamedEvaluation> evaluations);

}  // namespace shapegauge

#pragma once

#include "shapegauge/experiments/retrieval/run_experiment.h"
#include "shapegauge/pages/report.h"

namespace shapegauge {

/// The report of a run. It points into the results.
Report report_of(const ExperimentResults& results);

}  // namespace shapegauge

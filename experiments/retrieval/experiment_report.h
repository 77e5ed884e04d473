#pragma once

#include "shapegauge/experiments/retrieval/run_experiment.h"
#include "shapegauge/pages/report.h"

namespace shapegauge {

/// Makes the report of a run. It refers to the results.
Report report_of(const ExperimentResults& results);

}  // namespace shapegauge

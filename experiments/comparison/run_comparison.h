#pragma once

#include "shapegauge/experiments/comparison/comparison.h"
#include "shapegauge/experiments/comparison/comparison_results.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

/// Runs a whole comparison: fields, histograms, distances from the reference, errors. The shapes are measured one after
/// the other, each with all threads, so that their timings can be compared; all but the timings is the same for any
/// number of threads. Writes nothing. Throws InputError for a shape that fails with OnError::stop, for a reference that
/// fails, where no shape is left, and Interrupted.
ComparisonResults run_comparison(const Comparison& comparison, const RunControl& control);

}  // namespace shapegauge

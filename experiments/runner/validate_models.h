#pragma once

#include <vector>

#include "shapegauge/experiments/datasets/dataset_layouts.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

/// Reads every model as a run would, in parallel, and returns those that a run could not use, in order. Throws
/// Interrupted. Runs in the calling TBB arena.
std::vector<ModelFailure> validate_models(const Dataset& dataset, const RunControl& control);

}  // namespace shapegauge

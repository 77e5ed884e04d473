#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "shapegauge/experiments/datasets/dataset_layouts.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

/// Does a job for each of the models, in parallel over them, in the calling TBB arena. A job that throws is a failure
/// of its model; with stop_at_failure, jobs that have not begun by then are not done. Returns the failures, in order of
/// the models. Throws Interrupted.
std::vector<ModelFailure> for_each_model(std::span<const std::size_t> models, std::string_view stage,
                                         bool stop_at_failure, const RunControl& control,
                                         const std::function<void(std::size_t model)>& job);

}  // namespace shapegauge

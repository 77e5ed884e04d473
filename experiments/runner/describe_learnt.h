#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/datasets/layouts.h"
#include "shapegauge/experiments/runner/describe_model.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

/// Completes the features of the descriptors that learn: what they learn from the fields of all models, in order, is
/// taken from the cache or learnt and kept there, and then the features likewise. Models that are absent take no part.
/// Returns the models that cannot be described, in order; those after the first may be left out. Without them the
/// others learn something else: where there are any, nothing is complete, and it has to be called again without them.
/// Throws InputError or std::invalid_argument where nothing can be learnt, and Interrupted. Runs in the calling TBB
/// arena.
std::vector<ModelFailure> describe_learnt(std::vector<std::optional<ModelDescription>>& models,
                                          const Configuration& configuration, std::span<const PlannedField> plan,
                                          const RunControl& control, Cache& cache);

}  // namespace shapegauge

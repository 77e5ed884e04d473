#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/distributed/communicator.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/signatures/describe_model.h"

namespace shapegauge {

/// Descriptions of models by their index in the data set: those that this process has.
using DescribedModels = std::map<std::size_t, ModelDescription>;

/// Completes the features of the descriptors that learn: what they learn from the fields of all models, in order, is
/// taken from the cache or learnt and kept there, and then the features likewise. Of several processes rank 0 learns,
/// from the fields of all; each describes its own models. Models that are absent take no part. Returns the models that
/// cannot be described, in order, the same on all ranks; those after the first may be left out. Without them the others
/// learn something else: where there are any, nothing is complete, and it has to be called again without them. Throws
/// InputError where nothing can be learnt, and Interrupted. Collective. Runs in the calling
/// TBB arena. `learnt` becomes what the planned descriptors have learnt, empty for those that do not learn.
std::vector<ModelFailure> describe_learnt(DescribedModels& models, const Configuration& configuration,
                                          std::span<const PlannedField> plan, const RunControl& control, Cache& cache,
                                          Communicator& ranks, std::vector<LearntFeatures>& learnt);

}  // namespace shapegauge

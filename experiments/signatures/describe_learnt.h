// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "shapegauge/datasets/layouts/layouts.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/signatures/describe_model.h"

namespace shapegauge {

/// Descriptions of models by their index in the data set.
using DescribedModels = std::map<std::size_t, ModelDescription>;

/// Completes the features of descriptors that learn (needs_learning()): learns from the fields of all models, in order,
/// then computes the features of each model, both through the cache. Ignores missing models, and models without the
/// fields of a descriptor. With OnError::skip, models that a descriptor cannot describe get FeatureDescription::error,
/// and the descriptor learns again without them. With OnError::stop, returns the first such model, and the result is
/// incomplete. `learnt` receives the learnt features per signature, empty for a signature that does not learn. Throws
/// InputError if nothing can be learnt, and Interrupted. Runs in the calling TBB arena.
std::vector<ModelFailure> describe_learnt(DescribedModels& models, const Configuration& configuration,
                                          std::span<const Field> fields, const RunContext& context,
                                          std::vector<LearntFeatures>& learnt);

}  // namespace shapegauge

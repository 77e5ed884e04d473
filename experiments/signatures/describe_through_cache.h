#pragma once

#include <cstddef>
#include <span>

#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/signatures/describe_model.h"

namespace shapegauge {

/// Describes a model of the data set (describe_shape()): reads, perturbs, prepares and measures it, through the cache.
/// Missing fields are computed in one call and stored immediately. Apart from run times, the description is the same,
/// bit by bit, whatever the state of the cache. `parallel` distributes the samples over threads. Throws InputError for
/// an unusable model.
ModelDescription describe_through_cache(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                                        std::span<const PlannedField> plan, bool parallel, Cache& cache);

}  // namespace shapegauge

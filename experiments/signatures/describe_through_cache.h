#pragma once

#include <cstddef>
#include <span>

#include "shapegauge/datasets/layouts/dataset.h"
#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/signatures/describe_model.h"

namespace shapegauge {

/// Describes a model of the data set (describe_shape): it is read, perturbed, prepared and measured. What the cache
/// holds is taken from it; the fields that are missing are computed, in one call, and kept as soon as they are. The
/// description is the same, bit by bit but for the seconds, whatever the cache holds. parallel: spread the samples over
/// threads. Throws InputError for an unusable model.
ModelDescription describe_through_cache(const Dataset& dataset, std::size_t model, const Configuration& configuration,
                                        std::span<const PlannedField> plan, bool parallel, Cache& cache);

}  // namespace shapegauge

#pragma once

#include <cstddef>
#include <span>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/experiments/configuration/shape_comparison.h"
#include "shapegauge/experiments/engine/run_control.h"
#include "shapegauge/experiments/shape_comparison/measured_shape.h"
#include "shapegauge/experiments/signatures/describe_model.h"

namespace shapegauge {

/// Reads, perturbs and prepares the shape of that index, and computes the planned fields on it with all threads of the
/// calling TBB arena, through the cache. Run times from the cache are those of the run that computed the shape.
/// `reference` is the shape to compare with, if any; null for the reference itself. Throws as describe_shape() does,
/// and Interrupted between fields.
MeasuredShape measure_through_cache(const ShapeComparison& comparison, std::size_t index,
                                    std::span<const PlannedField> plan, const ReferenceShape* reference,
                                    const RunControl& control, Cache& cache);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/shape_comparison/run_shape_comparison.h"

namespace shapegauge {

/// Returns the entry for experiment_kinds().
ExperimentKind comparison_kind();

/// Writes all result files of a comparison but the manifest, and sets its entries.
RunOutcome write_shape_comparison(const RunResults& to, const ShapeComparisonResults& results);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/shape_comparison/run_shape_comparison.h"

namespace shapegauge {

/// Returns the kind of experiment for shape comparisons, for experiment_kinds().
ExperimentKind comparison_kind();

/// Writes all result files of a shape comparison except the manifest, and adds the entries of the comparison to the
/// manifest.
RunOutcome write_shape_comparison(const RunResults& to, const ShapeComparisonResults& results);

}  // namespace shapegauge

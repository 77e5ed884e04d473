#pragma once

#include <filesystem>

#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/shape_comparison/run_shape_comparison.h"

namespace shapegauge {

/// Returns the entry for experiment_kinds().
ExperimentKind comparison_kind();

/// Writes all result files of a comparison but the manifest into the folder.
RunOutcome write_shape_comparison(const std::filesystem::path& folder, const ShapeComparisonResults& results);

}  // namespace shapegauge

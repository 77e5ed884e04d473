#pragma once

#include <filesystem>

#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/segmentation/run_segmentation.h"

namespace shapegauge {

/// Returns the entry for experiment_kinds().
ExperimentKind segmentation_kind();

/// Writes all result files of a segmentation experiment (docs/manual/segmentation.md#experiments) but the manifest into
/// the folder.
RunOutcome write_segmentation(const std::filesystem::path& folder, const SegmentationResults& results);

}  // namespace shapegauge

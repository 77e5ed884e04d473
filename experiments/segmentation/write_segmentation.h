#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/segmentation/run_segmentation.h"

namespace shapegauge {

/// Returns the entry for experiment_kinds().
ExperimentKind segmentation_kind();

/// Writes all result files of a segmentation experiment (docs/manual/segmentation.md#experiments) but the manifest into
/// the folder.
RunOutcome write_segmentation(const std::filesystem::path& folder, const SegmentationResults& results);

/// Formats the errors of all methods as tables for a terminal.
std::string summary_text(const SegmentationResults& results);

}  // namespace shapegauge

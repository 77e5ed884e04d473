#pragma once

#include <filesystem>
#include <string>

#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/segmentation/run_segmentation.h"

namespace shapegauge {

/// The entry of the registry (experiment_kinds()).
ExperimentKind segmentation_kind();

/// Writes all result files of a segmentation experiment (docs/manual/segmentation.md#experiments) into the folder, each
/// whole or not at all, the manifest last, as write_results() does.
void write_segmentation(const std::filesystem::path& destination, const SegmentationResults& results);

/// The errors of all methods, in a terminal's tables.
std::string summary_text(const SegmentationResults& results);

}  // namespace shapegauge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/experiments/engine/experiment.h"
#include "shapegauge/experiments/segmentation/run_segmentation.h"

namespace shapegauge {

/// Returns the kind of experiment "segmentation", for experiment_kinds().
ExperimentKind segmentation_kind();

/// Writes all result files of a segmentation experiment (docs/manual/segmentation.md#experiments) except the manifest,
/// and adds the entries of the experiment to the manifest.
RunOutcome write_segmentation(const RunResults& to, const SegmentationResults& results);

}  // namespace shapegauge

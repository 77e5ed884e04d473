// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/experiments/segmentation/run_segmentation.h"
#include "shapegauge/pages/segmentation_page.h"

namespace shapegauge {

/// Makes the report of a segmentation experiment, with shapes in decreasing order of the first method's Rand error.
/// Pictures and views in the report refer to `results`, which must outlive it.
SegmentationPage segmentation_report(const SegmentationResults& results);

}  // namespace shapegauge

#pragma once

#include "shapegauge/experiments/segmentation/run_segmentation.h"
#include "shapegauge/pages/segmentation_page.h"

namespace shapegauge {

/// The report of a segmentation experiment, shapes of the greatest Rand error of the first method first. Its pictures
/// point into the results.
SegmentationPage report_of(const SegmentationResults& results);

}  // namespace shapegauge

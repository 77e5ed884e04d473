// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/segmentation/run_segmentation.h"

namespace shapegauge {

/// Measures the consistency of parts among the shapes of a class, without human segmentations: a row for each method
/// and class, and for each method the mean of its classes.
/// - "parts": median number of parts, without parts of less than 1 % of the area.
/// - "same number": fraction of pairs of shapes of the class with the same number of parts.
/// - "sizes": mean difference in size over those pairs: half the sum of differences between the area fractions of the
///   largest parts, the second largest, and so on. 0 if all are equal, at most 1.
/// - "sizes, others": the same over pairs of a shape of the class and one of another class.
TextTable consistency_table(const SegmentationResults& results);

/// Measures the effect of perturbations on the parts: a row for each method with perturbations, with the median, mean
/// and maximum of SegmentedShape::moved.
TextTable moved_table(const SegmentationResults& results);

}  // namespace shapegauge

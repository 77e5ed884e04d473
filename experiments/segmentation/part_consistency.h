// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/segmentation/run_segmentation.h"

namespace shapegauge {

/// Makes a table of the consistency of segmentations among the shapes of a class, without human segmentations: a row
/// for each method and class, and a row for each method with the mean over its classes. Columns:
/// - "parts": median number of parts, without parts of less than 1 % of the area.
/// - "same number": fraction of pairs of shapes of the class with the same number of parts.
/// - "sizes": mean difference in size over pairs of shapes of the class: half the sum of differences between the area
///   fractions of the largest parts, the second largest, and so on. 0 if all are equal, at most 1.
/// - "sizes, others": mean difference in size over pairs of a shape of the class and a shape of another class.
TextTable consistency_table(const SegmentationResults& results);

/// Makes a table of the effect of perturbations on segmentations: a row for each method with perturbations, with the
/// median, mean and maximum over the shapes of SegmentedShape::perturbation_errors (Rand error relative to the
/// unperturbed shape).
TextTable perturbation_effect_table(const SegmentationResults& results);

}  // namespace shapegauge

#pragma once

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/segmentation/run_segmentation.h"

namespace shapegauge {

/// How alike the parts of the shapes of a class are, which takes no people: a row for each method and class, and for
/// each method the mean of its classes.
///
/// - "parts": the median number of parts. Parts of less than 1 % of the area do not count here.
/// - "same number": of pairs of shapes of the class, the fraction with the same number of parts.
/// - "sizes": of those pairs the mean difference in size, half the sum of the differences between the fractions of the
///   area that the largest parts have, the second largest, and so on: 0 where all are the same, at most 1.
/// - "sizes, others": the same of the pairs of a shape of the class and one of another class.
Table consistency_table(const SegmentationResults& results);

/// What perturbations change of the parts: a row for each method that has some, with the median, the mean and the
/// greatest of SegmentedShape::moved. No row where no method has perturbations.
Table moved_table(const SegmentationResults& results);

}  // namespace shapegauge

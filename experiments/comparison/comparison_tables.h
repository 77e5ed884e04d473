#pragma once

#include "shapegauge/experiments/comparison/comparison_results.h"
#include "shapegauge/experiments/text/table.h"

namespace shapegauge {

/// A row for each signature, shape and bin: the bin's number and bounds, and its share of the area.
Table histograms_table(const ComparisonResults& results);

/// A row for each signature and shape: its distance from the reference. Without a reference, no rows.
Table distances_table(const ComparisonResults& results);

/// A row for each signature and shape: samples, those without a value, and the ValueErrors, if there are any.
Table errors_table(const ComparisonResults& results);

/// A row for each signature whose field estimates normals, and shape: the NormalErrors of those and of its own.
Table normals_table(const ComparisonResults& results);

/// A row for each signature and shape: how long things took. The one table that differs from run to run.
Table timings_table(const ComparisonResults& results);

}  // namespace shapegauge
